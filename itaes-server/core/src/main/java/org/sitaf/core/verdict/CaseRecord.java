package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.timing.RepeatedCalls;

/**
 * The record of one case, as written by a test application. Contains measurements only: {@link
 * ResultAssembler} compares them with the expected values and sets the verdict.
 *
 * @param no number of the case in the suite
 * @param thrown name of the exception's type without its package or namespace; empty unless the
 *     outcome is {@link Outcome#THREW}
 * @param actual recorded values of the outputs
 * @param calls of required interfaces
 * @param time of the call; null if the call did not end
 * @param repeated the repeated calls; null if there are none
 * @param notes what the component did that the test does not look at
 * @param message describes the exception or the reason; empty if the call returned
 * @param steps the steps of a sequence that ended, in their order; empty if the case is one call
 * @param ports values of the output data ports that trajectory conditions use
 */
public record CaseRecord(
    int no,
    Outcome outcome,
    String thrown,
    List<NamedValue> actual,
    StubCalls calls,
    CaseResult.@Nullable ProcessingTime time,
    @Nullable RepeatedCalls repeated,
    String message,
    List<String> notes,
    List<StepRecord> steps,
    List<PortChanges> ports) {
  public CaseRecord {
    Objects.requireNonNull(outcome);
    Objects.requireNonNull(thrown);
    actual = List.copyOf(actual);
    Objects.requireNonNull(calls);
    Objects.requireNonNull(message);
    notes = List.copyOf(notes);
    steps = List.copyOf(steps);
    ports = List.copyOf(ports);
  }

  /** A record without steps. */
  public CaseRecord(
      int no,
      Outcome outcome,
      String thrown,
      List<NamedValue> actual,
      StubCalls calls,
      CaseResult.@Nullable ProcessingTime time,
      @Nullable RepeatedCalls repeated,
      String message,
      List<String> notes) {
    this(no, outcome, thrown, actual, calls, time, repeated, message, notes, List.of(), List.of());
  }

  /** A record without notes. */
  public CaseRecord(
      int no,
      Outcome outcome,
      String thrown,
      List<NamedValue> actual,
      StubCalls calls,
      CaseResult.@Nullable ProcessingTime time,
      @Nullable RepeatedCalls repeated,
      String message) {
    this(no, outcome, thrown, actual, calls, time, repeated, message, List.of());
  }

  /** A record without repeated calls. */
  public CaseRecord(
      int no,
      Outcome outcome,
      String thrown,
      List<NamedValue> actual,
      StubCalls calls,
      CaseResult.@Nullable ProcessingTime time,
      String message) {
    this(no, outcome, thrown, actual, calls, time, null, message);
  }

  /** How the case ended. */
  public enum Outcome {
    /** The call returned, and its outputs are recorded. */
    RETURNED,
    /** The call under test threw an exception. */
    THREW,
    /** Anything else failed: creation, set-up, a periodic tick, a limit. */
    ERROR,
    /** The component was not called. */
    NOT_CALLED
  }

  /** The record of a case that ended without its test application. */
  public static CaseRecord error(int no, String message) {
    return new CaseRecord(no, Outcome.ERROR, "", List.of(), StubCalls.NONE, null, message);
  }

  /** The outputs as results show them: a single one has no name. */
  List<NamedValue> outputs() {
    return actual.size() == 1 ? List.of(new NamedValue("", actual.get(0).literal())) : actual;
  }

  /** A copy for the case of another number. */
  public CaseRecord numbered(int other) {
    return other == no
        ? this
        : new CaseRecord(
            other, outcome, thrown, actual, calls, time, repeated, message, notes, steps, ports);
  }

  /** A copy without processing times. */
  public CaseRecord withoutTime() {
    return new CaseRecord(
        no, outcome, thrown, actual, calls, null, null, message, notes, steps, ports);
  }

  /** A copy with the steps of a sequence. */
  public CaseRecord with(List<StepRecord> ended) {
    return new CaseRecord(
        no, outcome, thrown, actual, calls, time, repeated, message, notes, ended, ports);
  }

  /** A copy with values of output data ports. */
  public CaseRecord withPorts(List<PortChanges> changes) {
    return new CaseRecord(
        no, outcome, thrown, actual, calls, time, repeated, message, notes, steps, changes);
  }

  /** A copy that says that its call was the first of its process. */
  public CaseRecord ofFirstCall() {
    return time == null
        ? this
        : new CaseRecord(
            no,
            outcome,
            thrown,
            actual,
            calls,
            new CaseResult.ProcessingTime(time.total(), time.hardware(), time.stub(), true),
            repeated,
            message,
            notes,
            steps,
            ports);
  }
}
