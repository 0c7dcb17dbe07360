package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;

/**
 * Confirms a PASS by what was measured: the recorded values of the outputs within the model's
 * tolerances. A test application compares at once, in its own process, which the component shares.
 */
final class Expectations {
  private static final String ERROR = "!error:";
  private static final String UNEVALUATED = "!unevaluated:";
  private static final String REPORTED = ", though the test application reported PASS";

  private final TestModel model;

  Expectations(TestModel model) {
    this.model = Objects.requireNonNull(model);
  }

  /** The result with the worse verdict of the two; only a PASS can become worse. */
  CaseResult confirm(TestCase testCase, CaseResult result) {
    if (result.verdict() != Verdict.PASS
        || testCase.expected().isEmpty()
        || isExpectedError(testCase, result)) {
      return result;
    }
    Verdict verdict = Verdict.PASS;
    List<String> differences = new ArrayList<>();
    for (ExpectedValue expected : testCase.expected()) {
      if (expected.literal().startsWith(UNEVALUATED)) {
        verdict = Verdict.ERROR;
        differences.add(
            "what is expected has no value:" + expected.literal().substring(UNEVALUATED.length()));
        continue;
      }
      String actual = actual(expected, result);
      Optional<String> difference = Optional.empty();
      if (actual == null) {
        verdict = Verdict.ERROR;
        difference = Optional.of("no value of it was recorded");
      } else if (expected.literal().startsWith(ERROR)) {
        difference =
            Optional.of(
                "expected the error "
                    + expected.literal().substring(ERROR.length())
                    + ", but it returned "
                    + RecordedValue.shortened(actual));
      } else {
        difference = difference(expected, actual);
      }
      if (difference.isPresent()) {
        verdict = verdict.worse(Verdict.FAIL);
        differences.add(named(testCase, expected, difference.get()));
      }
    }
    return differences.isEmpty()
        ? result
        : result.judged(verdict, String.join("; ", differences) + REPORTED);
  }

  private Optional<String> difference(ExpectedValue expected, String actual) {
    if (expected.literal().equals(actual)) {
      return Optional.empty();
    }
    OutputElement output = model.output(expected.output()).orElse(null);
    return output == null
        ? RecordedValue.UNTYPED.difference(expected.literal(), actual)
        : new RecordedValue(output.type(), output.tolerance())
            .difference(expected.literal(), actual);
  }

  /** Where the call threw what is expected of any output, the case is judged by that alone. */
  private static boolean isExpectedError(TestCase testCase, CaseResult result) {
    for (ExpectedValue expected : testCase.expected()) {
      if (expected.literal().startsWith(ERROR)) {
        String error = expected.literal().strip();
        for (NamedValue actual : result.actual()) {
          if (actual.literal().equals(error)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** What was recorded of an output; a name is left out where there is only one. */
  private @Nullable String actual(ExpectedValue expected, CaseResult result) {
    List<NamedValue> recorded = result.actual();
    if (recorded.size() == 1
        && (recorded.get(0).output().isEmpty() || expected.output().isEmpty())
        && model.outputs().size() <= 1) {
      return recorded.get(0).literal();
    }
    String name =
        expected.output().isEmpty() && model.outputs().size() == 1
            ? model.outputs().get(0).name()
            : expected.output();
    for (NamedValue actual : recorded) {
      if (actual.output().equals(name)) {
        return actual.literal();
      }
    }
    // A driver that a person wrote may name the only value of a case as it likes.
    return expected.output().isEmpty() && !recorded.isEmpty() ? recorded.get(0).literal() : null;
  }

  private static String named(TestCase testCase, ExpectedValue expected, String difference) {
    return testCase.expected().size() > 1 ? expected.output() + ": " + difference : difference;
  }
}
