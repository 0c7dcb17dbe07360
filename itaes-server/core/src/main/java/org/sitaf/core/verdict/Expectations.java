package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;

/**
 * Compares a recorded case with the expected values of the suite, within the tolerances of the
 * model.
 */
final class Expectations {
  private static final String UNEVALUATED = "!unevaluated:";

  private final TestModel model;

  Expectations(TestModel model) {
    this.model = Objects.requireNonNull(model);
  }

  /** The result of a case before its post-conditions are evaluated. */
  CaseResult judge(TestCase testCase, CaseRecord record) {
    return switch (record.outcome()) {
      case RETURNED -> compareOutputs(testCase, record);
      case THREW -> checkException(testCase, record);
      case ERROR -> result(testCase, record, Verdict.ERROR, record.message());
      case NOT_CALLED -> result(testCase, record, Verdict.DONT, record.message());
    };
  }

  private CaseResult compareOutputs(TestCase testCase, CaseRecord record) {
    Verdict verdict = Verdict.PASS;
    List<String> messages = new ArrayList<>();
    for (ExpectedValue expected : testCase.expected()) {
      Optional<Mismatch> mismatch = mismatch(expected, record);
      if (mismatch.isPresent()) {
        verdict = verdict.worse(mismatch.get().verdict());
        messages.add(message(testCase, outputName(expected, record), mismatch.get()));
      }
    }
    return result(testCase, record, verdict, String.join("; ", messages));
  }

  private Optional<Mismatch> mismatch(ExpectedValue expected, CaseRecord record) {
    String literal = expected.literal();
    String stripped = literal.strip();
    if (stripped.startsWith(UNEVALUATED)) {
      return Optional.of(
          new Mismatch(
              Verdict.ERROR,
              "",
              "the expected value could not be evaluated: "
                  + stripped.substring(UNEVALUATED.length()).strip()));
    }
    if (stripped.equals(Value.ANY)) {
      return Optional.empty();
    }
    String output = outputName(expected, record);
    String actual = actual(output, record);
    boolean isErrorExpected =
        stripped.equals(Value.ANY_ERROR) || stripped.startsWith(Value.ERROR_PREFIX);
    // A call without outputs, such as a forbidden one, records no value.
    if (actual == null && !isErrorExpected) {
      return Optional.of(
          new Mismatch(
              Verdict.ERROR,
              "",
              "the test application recorded no value of the output '" + output + "'"));
    }
    Optional<OutputElement> element = model.output(output);
    if (actual == null || isErrorExpected) {
      boolean valueless = actual == null || element.isPresent() && element.get().type().isVoid();
      return Optional.of(
          new Mismatch(
              Verdict.FAIL,
              "",
              (stripped.equals(Value.ANY_ERROR)
                      ? "expected an error"
                      : "expected the error " + stripped.substring(Value.ERROR_PREFIX.length()))
                  + ", but it returned"
                  + (valueless ? "" : " " + Literals.shortened(actual))));
    }
    if (actual.equals(Literals.NULL) && output.endsWith("]") && !literal.equals(actual)) {
      return Optional.of(
          new Mismatch(
              Verdict.FAIL,
              "",
              "expected " + Literals.shortened(literal) + ", but there is no such element"));
    }
    return element
        .map(e -> new ValueComparison(e.type(), e.tolerance()))
        .orElse(ValueComparison.UNTYPED)
        .mismatch(literal, actual);
  }

  /**
   * If the expected exception was thrown, the case passes: the expected values of the other outputs
   * are not compared.
   */
  private CaseResult checkException(TestCase testCase, CaseRecord record) {
    List<NamedValue> matched = new ArrayList<>();
    for (ExpectedValue expected : testCase.expected()) {
      if (allows(expected, record)) {
        matched.add(new NamedValue(expected.output(), Value.ERROR_PREFIX + record.thrown()));
      }
    }
    boolean unjudged =
        testCase.expected().stream().allMatch(e -> e.literal().strip().equals(Value.ANY));
    if (matched.isEmpty() && unjudged) {
      testCase
          .expected()
          .forEach(
              e -> matched.add(new NamedValue(e.output(), Value.ERROR_PREFIX + record.thrown())));
    }
    if (matched.isEmpty()) {
      return result(testCase, record.withoutTime(), Verdict.ERROR, record.message());
    }
    return new CaseResult(
        testCase.no(),
        Verdict.PASS,
        testCase.values(),
        expected(testCase),
        matched,
        record.calls(),
        record.time(),
        "");
  }

  /** Whether the exception is the expected one, any of an output, or replaces its value. */
  private boolean allows(ExpectedValue expected, CaseRecord record) {
    String literal = expected.literal().strip();
    boolean isExpected =
        literal.startsWith(Value.ERROR_PREFIX)
            && isNamed(literal.substring(Value.ERROR_PREFIX.length()), record.thrown());
    return isExpected
        || literal.equals(Value.ANY_ERROR)
        || model
            .output(outputName(expected, record))
            .filter(o -> o.orErrors().stream().anyMatch(name -> isNamed(name, record.thrown())))
            .isPresent();
  }

  /**
   * Whether an exception has a name, which may be qualified as in the component's language: records
   * contain simple names.
   */
  private static boolean isNamed(String name, String thrown) {
    int end = Math.max(name.lastIndexOf("::") + 1, name.lastIndexOf('.'));
    return name.equals(thrown) || name.substring(end + 1).equals(thrown);
  }

  private CaseResult result(TestCase testCase, CaseRecord record, Verdict verdict, String message) {
    return new CaseResult(
        testCase.no(),
        verdict,
        testCase.values(),
        expected(testCase),
        record.outputs(),
        record.calls(),
        record.time(),
        message);
  }

  private static List<NamedValue> expected(TestCase testCase) {
    return testCase.expected().stream().map(e -> new NamedValue(e.output(), e.literal())).toList();
  }

  /** The output of an expected value. The suite omits the name if there is only one output. */
  private String outputName(ExpectedValue expected, CaseRecord record) {
    if (!expected.output().isEmpty()) {
      return expected.output();
    }
    if (model.outputs().size() == 1) {
      return model.outputs().get(0).name();
    }
    return record.actual().isEmpty() ? OutputElement.RETURN_NAME : record.actual().get(0).output();
  }

  private static @Nullable String actual(String output, CaseRecord record) {
    for (NamedValue actual : record.actual()) {
      if (actual.output().equals(output)) {
        return actual.literal();
      }
    }
    return null;
  }

  private static String message(TestCase testCase, String output, Mismatch mismatch) {
    boolean named = testCase.expected().size() > 1 || !mismatch.path().isEmpty();
    return named ? output + mismatch.path() + ": " + mismatch.text() : mismatch.text();
  }
}
