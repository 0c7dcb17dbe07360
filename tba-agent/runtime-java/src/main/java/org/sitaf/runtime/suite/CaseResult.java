package org.sitaf.runtime.suite;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** What becomes of one case; the test driver fills it in and saves it. */
public final class CaseResult {
  private final TestCase testCase;
  private final Map<String, String> actual = new LinkedHashMap<>();
  private final Set<String> compared = new HashSet<>();
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
    compared.add(testCase.expectations().containsKey(output) ? output : "");
    try {
      Comparison.difference(expected.get(), value, tolerance)
          .ifPresent(difference -> worsen(Verdict.FAIL, named(output, difference)));
    } catch (CaseDataException e) {
      worsen(
          Verdict.ERROR,
          named(output, "what is expected cannot be compared with it: " + e.getMessage()));
    }
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
    if (time != null) {
      line.time(time);
    }
    if (!message.isEmpty()) {
      line.message(message);
    }
    return line.close();
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
