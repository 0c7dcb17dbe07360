package org.sitaf.runtime.suite;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** What becomes of one case; the test driver fills it in and saves it. */
public final class CaseResult {
  /** Begins an expected value that could not be worked out. */
  private static final String UNEVALUATED = "!unevaluated:";

  private record Call(String method, List<String> parameters, List<String> arguments) {}

  private final TestCase testCase;
  private final Map<String, String> actual = new LinkedHashMap<>();
  private final Set<String> compared = new HashSet<>();
  private final List<Call> calls = new ArrayList<>();
  private long furtherCalls;
  private @Nullable ProcessingTime time;
  private Verdict verdict = Verdict.PASS;
  private String message = "";

  /** A result of a case that nothing is known of yet. */
  public CaseResult(TestCase testCase) {
    this.testCase = Objects.requireNonNull(testCase);
  }

  /**
   * Processing time in microseconds.
   *
   * @param component the component's own, without what follows
   * @param hardware spent in virtual hardware
   * @param stub spent in stubs
   */
  record ProcessingTime(double component, double hardware, double stub) {}

  /** Keeps how long the call took; all in microseconds, the first without the other two. */
  public void took(double component, double hardware, double stub) {
    time = new ProcessingTime(component, hardware, stub);
  }

  /** Keeps an output that nothing is expected of. */
  public void record(String output, @Nullable Object value) {
    actual.put(output, Literals.of(value));
  }

  /** Keeps an output, and compares it where the case expects something of it. */
  public void compare(String output, @Nullable Object value, Tolerance tolerance) {
    record(output, value);
    Optional<String> expected = testCase.expected(output);
    if (expected.isEmpty()) {
      return;
    }
    compare(output, expected.get(), value, tolerance);
  }

  /**
   * Keeps and compares a part of an output; one that is not there differs.
   *
   * @param output such as {@code pose.x} or {@code path[3]}
   * @param whole the value of the output that the name begins with
   */
  public void comparePart(String output, @Nullable Object whole, Tolerance tolerance) {
    Optional<Object> part = Parts.of(whole, output);
    Optional<String> expected = testCase.expected(output);
    record(output, part.orElse(null));
    if (part.isEmpty() && expected.isPresent()) {
      compared.add(testCase.expectations().containsKey(output) ? output : "");
      worsen(
          Verdict.FAIL, output + ": expected " + expected.get() + ", but there is no such element");
    } else {
      expected.ifPresent(literal -> compare(output, literal, part.get(), tolerance));
    }
  }

  /**
   * Keeps that a method returned which returns nothing, and compares that where the case expects
   * something: that it returns, {@code null}, or an error.
   */
  public void returnedNothing(String output) {
    record(output, null);
    Optional<String> expected = testCase.expected(output);
    if (expected.isPresent() && !isNoValue(output, expected.get(), "")) {
      if (!expected.get().strip().equals(Literals.of(null))) {
        worsen(
            Verdict.ERROR,
            "nothing is returned, so that "
                + expected.get()
                + " cannot be expected, but null or an error such as !error:NAME");
      }
    }
  }

  private void compare(
      String output, String expected, @Nullable Object value, Tolerance tolerance) {
    if (isNoValue(output, expected, " " + Literals.of(value))) {
      return;
    }
    try {
      Comparison.difference(expected, value, tolerance)
          .ifPresent(d -> worsen(Verdict.FAIL, named(output, d)));
    } catch (CaseDataException e) {
      worsen(
          Verdict.ERROR,
          named(output, "what is expected cannot be compared with it: " + e.getMessage()));
    }
  }

  /** Judges an output of which no value is expected, but an error, or that is not known. */
  private boolean isNoValue(String output, String expected, String returned) {
    compared.add(testCase.expectations().containsKey(output) ? output : "");
    if (expected.startsWith(UNEVALUATED)) {
      worsen(
          Verdict.ERROR,
          "what is expected has no value:" + expected.substring(UNEVALUATED.length()));
      return true;
    }
    if (expected.startsWith(Answer.ERROR)) {
      String error = expected.substring(Answer.ERROR.length());
      worsen(Verdict.FAIL, "expected the error " + error + ", but it returned" + returned);
      return true;
    }
    return false;
  }

  /**
   * Whether the case expects what the call threw; it is judged by that then, and everything else
   * that it expects counts as met.
   */
  public boolean expects(Throwable thrown) {
    String literal = Answer.ERROR + thrown.getClass().getSimpleName();
    for (Map.Entry<String, String> expectation : testCase.expectations().entrySet()) {
      if (expectation.getValue().equals(literal)) {
        actual.put(expectation.getKey(), literal);
        compared.addAll(testCase.expectations().keySet());
        return true;
      }
    }
    return false;
  }

  /** A value as results spell it. */
  public static String spelling(@Nullable Object value) {
    return Literals.of(value);
  }

  /**
   * Keeps a call of a required interface.
   *
   * @param method {@code Interface.Method}
   * @param arguments as {@link #spelling} has them, one for each of the parameters
   */
  public void called(String method, List<String> parameters, List<String> arguments) {
    calls.add(new Call(method, parameters, arguments));
  }

  /** Counts calls that are not kept. */
  public void calledFurther(long count) {
    furtherCalls += count;
  }

  /** The case did not get as far as a comparison, or not through it. */
  public void endedWith(Verdict newVerdict, String reason) {
    worsen(newVerdict, reason);
  }

  /**
   * The result as one line of XML, line feed included. An expected value that no output was
   * compared with makes an ERROR of a case that would pass unseen.
   */
  String line() {
    if (verdict == Verdict.PASS) {
      for (String output : testCase.expectations().keySet()) {
        if (!compared.contains(output)) {
          worsen(
              Verdict.ERROR,
              "the suite expects a value of '"
                  + output
                  + "', which the test application does not know");
        }
      }
    }
    boolean named = actual.size() > 1;
    ResultLine line = new ResultLine();
    line.open(testCase.no(), verdict);
    testCase.literals().forEach(line::value);
    testCase.expectations().forEach((output, literal) -> line.output("expected", output, literal));
    actual.forEach((output, literal) -> line.output("actual", named ? output : "", literal));
    for (Call call : calls) {
      line.call(call.method(), call.parameters(), call.arguments());
    }
    if (furtherCalls > 0) {
      line.callsLeftOut(furtherCalls);
    }
    if (time != null) {
      line.time(time);
    }
    if (!message.isEmpty()) {
      line.message(message);
    }
    return line.close();
  }

  private String named(String output, Comparison.Difference difference) {
    return difference.way().isEmpty()
        ? named(output, difference.text())
        : output + difference.way() + ": " + difference.text();
  }

  private String named(String output, String difference) {
    return testCase.expectations().size() > 1 ? output + ": " + difference : difference;
  }

  private void worsen(Verdict newVerdict, String reason) {
    if (newVerdict.compareTo(verdict) > 0) {
      verdict = newVerdict;
    }
    message = message.isEmpty() ? reason : message + "; " + reason;
  }
}
