package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The result of one case.
 *
 * @param values literals in the order of the suite's parameters
 * @param calls of required interfaces
 * @param trajectories results of the trajectory conditions; empty if they were not evaluated
 * @param time null if the call did not end
 * @param message why the verdict is not PASS; empty otherwise
 */
public record CaseResult(
    int no,
    Verdict verdict,
    List<String> values,
    List<NamedValue> expected,
    List<NamedValue> actual,
    StubCalls calls,
    List<TrajectoryResult> trajectories,
    @Nullable ProcessingTime time,
    String message) {
  public CaseResult {
    Objects.requireNonNull(verdict);
    Objects.requireNonNull(message);
    values = List.copyOf(values);
    expected = List.copyOf(expected);
    actual = List.copyOf(actual);
    Objects.requireNonNull(calls);
    // Stored results of earlier versions have none.
    trajectories = trajectories == null ? List.of() : List.copyOf(trajectories);
  }

  /** A result of a case in which the component called no required interface. */
  public CaseResult(
      int no,
      Verdict verdict,
      List<String> values,
      List<NamedValue> expected,
      List<NamedValue> actual,
      @Nullable ProcessingTime time,
      String message) {
    this(no, verdict, values, expected, actual, StubCalls.NONE, time, message);
  }

  /** A result without trajectory conditions. */
  public CaseResult(
      int no,
      Verdict verdict,
      List<String> values,
      List<NamedValue> expected,
      List<NamedValue> actual,
      StubCalls calls,
      @Nullable ProcessingTime time,
      String message) {
    this(no, verdict, values, expected, actual, calls, List.of(), time, message);
  }

  /** A copy with the results of trajectory conditions. */
  public CaseResult with(List<TrajectoryResult> results) {
    return new CaseResult(no, verdict, values, expected, actual, calls, results, time, message);
  }

  /** A copy with another verdict. The reason is added to the message. */
  public CaseResult withVerdict(Verdict newVerdict, String reason) {
    return new CaseResult(
        no,
        newVerdict,
        values,
        expected,
        actual,
        calls,
        trajectories,
        time,
        message.isEmpty() ? reason : message + "; " + reason);
  }

  /**
   * Processing time of a call in microseconds.
   *
   * @param total the component's own time, without the other two
   * @param hardware spent in virtual hardware
   * @param stub spent in stubs
   */
  public record ProcessingTime(double total, double hardware, double stub) {}
}
