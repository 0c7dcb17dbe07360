package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.timing.RepeatedCalls;

/**
 * The result of one case.
 *
 * @param values literals in the order of the suite's parameters
 * @param calls of required interfaces
 * @param trajectories results of the trajectory conditions; empty if they were not evaluated
 * @param relations results of the relations between two runs; empty if they were not checked
 * @param time of the judged call; null if it did not end
 * @param repeated the repeated calls; null if there are none
 * @param message why the verdict is not PASS; empty otherwise
 * @param notes what the component did that the test does not look at
 * @param steps of a sequence; empty if the case is one call
 * @param hardware what was measured with devices that are not simulated; null if all are
 */
public record CaseResult(
    int no,
    Verdict verdict,
    List<String> values,
    List<NamedValue> expected,
    List<NamedValue> actual,
    StubCalls calls,
    List<TrajectoryResult> trajectories,
    List<RelationResult> relations,
    @Nullable ProcessingTime time,
    @Nullable RepeatedCalls repeated,
    String message,
    List<String> notes,
    List<StepResult> steps,
    @Nullable HardwareReport hardware) {
  public CaseResult {
    Objects.requireNonNull(verdict);
    Objects.requireNonNull(message);
    values = List.copyOf(values);
    expected = List.copyOf(expected);
    actual = List.copyOf(actual);
    Objects.requireNonNull(calls);
    // Stored results of earlier versions have none.
    trajectories = trajectories == null ? List.of() : List.copyOf(trajectories);
    relations = relations == null ? List.of() : List.copyOf(relations);
    notes = notes == null ? List.of() : List.copyOf(notes);
    steps = steps == null ? List.of() : List.copyOf(steps);
  }

  /** A result with simulated devices. */
  public CaseResult(
      int no,
      Verdict verdict,
      List<String> values,
      List<NamedValue> expected,
      List<NamedValue> actual,
      StubCalls calls,
      List<TrajectoryResult> trajectories,
      List<RelationResult> relations,
      @Nullable ProcessingTime time,
      @Nullable RepeatedCalls repeated,
      String message,
      List<String> notes,
      List<StepResult> steps) {
    this(
        no,
        verdict,
        values,
        expected,
        actual,
        calls,
        trajectories,
        relations,
        time,
        repeated,
        message,
        notes,
        steps,
        null);
  }

  /** A result without steps. */
  public CaseResult(
      int no,
      Verdict verdict,
      List<String> values,
      List<NamedValue> expected,
      List<NamedValue> actual,
      StubCalls calls,
      List<TrajectoryResult> trajectories,
      List<RelationResult> relations,
      @Nullable ProcessingTime time,
      @Nullable RepeatedCalls repeated,
      String message,
      List<String> notes) {
    this(
        no,
        verdict,
        values,
        expected,
        actual,
        calls,
        trajectories,
        relations,
        time,
        repeated,
        message,
        notes,
        List.of());
  }

  /** A result without notes. */
  public CaseResult(
      int no,
      Verdict verdict,
      List<String> values,
      List<NamedValue> expected,
      List<NamedValue> actual,
      StubCalls calls,
      List<TrajectoryResult> trajectories,
      List<RelationResult> relations,
      @Nullable ProcessingTime time,
      @Nullable RepeatedCalls repeated,
      String message) {
    this(
        no,
        verdict,
        values,
        expected,
        actual,
        calls,
        trajectories,
        relations,
        time,
        repeated,
        message,
        List.of());
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

  /** A result without trajectory conditions and relations. */
  public CaseResult(
      int no,
      Verdict verdict,
      List<String> values,
      List<NamedValue> expected,
      List<NamedValue> actual,
      StubCalls calls,
      @Nullable ProcessingTime time,
      String message) {
    this(no, verdict, values, expected, actual, calls, List.of(), List.of(), time, null, message);
  }

  /** A copy with the results of trajectory conditions. */
  public CaseResult with(List<TrajectoryResult> results) {
    return copy(verdict, results, relations, repeated, message);
  }

  /** A copy with what the component did that the test does not look at. */
  public CaseResult withNotes(List<String> found) {
    return new CaseResult(
        no,
        verdict,
        values,
        expected,
        actual,
        calls,
        trajectories,
        relations,
        time,
        repeated,
        message,
        found,
        steps,
        hardware);
  }

  /** A copy with the steps of a sequence. */
  public CaseResult withSteps(List<StepResult> executed) {
    return new CaseResult(
        no,
        verdict,
        values,
        expected,
        actual,
        calls,
        trajectories,
        relations,
        time,
        repeated,
        message,
        notes,
        executed,
        hardware);
  }

  /** A copy with what was measured with devices that are not simulated. */
  public CaseResult with(HardwareReport measured) {
    return new CaseResult(
        no,
        verdict,
        values,
        expected,
        actual,
        calls,
        trajectories,
        relations,
        time,
        repeated,
        message,
        notes,
        steps,
        measured);
  }

  /** A copy with the results of relations. */
  public CaseResult withRelations(List<RelationResult> results) {
    return copy(verdict, trajectories, results, repeated, message);
  }

  /** A copy with repeated calls. */
  public CaseResult with(RepeatedCalls measured) {
    return copy(verdict, trajectories, relations, measured, message);
  }

  /** A copy with another verdict. The reason is added to the message. */
  public CaseResult withVerdict(Verdict newVerdict, String reason) {
    String both = message.isEmpty() ? reason : message + "; " + reason;
    return copy(newVerdict, trajectories, relations, repeated, both);
  }

  private CaseResult copy(
      Verdict newVerdict,
      List<TrajectoryResult> newTrajectories,
      List<RelationResult> newRelations,
      @Nullable RepeatedCalls newRepeated,
      String newMessage) {
    return new CaseResult(
        no,
        newVerdict,
        values,
        expected,
        actual,
        calls,
        newTrajectories,
        newRelations,
        time,
        newRepeated,
        newMessage,
        notes,
        steps,
        hardware);
  }

  /**
   * The time that stands for the case, in microseconds: the median of its repeated calls, else the
   * time of its call. Empty if the call did not end.
   */
  public OptionalDouble micros() {
    if (repeated != null && repeated.median() != null) {
      return OptionalDouble.of(repeated.median());
    }
    return time == null ? OptionalDouble.empty() : OptionalDouble.of(time.total());
  }

  /**
   * Processing time of a call in microseconds.
   *
   * @param total the component's own time, without the other two
   * @param hardware spent in virtual hardware
   * @param stub spent in stubs
   * @param cold never null: whether this is the first call of its process, which also loads and
   *     compiles code
   */
  public record ProcessingTime(double total, double hardware, double stub, @Nullable Boolean cold) {
    public ProcessingTime {
      // Stored results of earlier versions have none.
      cold = Boolean.TRUE.equals(cold);
    }

    /** The time of a call that is not the first of its process. */
    public ProcessingTime(double total, double hardware, double stub) {
      this(total, hardware, stub, false);
    }
  }
}
