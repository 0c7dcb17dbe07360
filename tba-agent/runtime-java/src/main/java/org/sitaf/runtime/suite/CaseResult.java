package org.sitaf.runtime.suite;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The record of a case or of a step. The test driver fills it in and saves it; it contains neither
 * expected values nor verdicts, which the agent adds.
 */
public final class CaseResult {
  /** Longest value in the text about a difference, in characters. */
  private static final int MAX_DIFFERENCE = 200;

  private record Call(String method, List<String> parameters, List<String> arguments) {}

  private record Port(String signal, List<PortChange> changes, long leftOut) {}

  private final TestCase testCase;
  private final Map<String, String> actual = new LinkedHashMap<>();
  private final List<Call> calls = new ArrayList<>();
  private final List<Port> ports = new ArrayList<>();
  private long callsLeftOut;
  private @Nullable ProcessingTime time;
  private Outcome outcome = Outcome.RETURNED;
  private String thrown = "";
  private String message = "";
  private @Nullable RepeatedCalls repeated;
  private long atNanos;

  /** An empty record of a case. */
  public CaseResult(TestCase testCase) {
    this.testCase = Objects.requireNonNull(testCase);
  }

  /**
   * Processing time in microseconds.
   *
   * @param component time of the component itself, without hardware and stub
   * @param hardware time in virtual hardware
   * @param stub time in stubs
   */
  record ProcessingTime(double component, double hardware, double stub) {}

  /** Sets the processing time in microseconds; {@code component} excludes the other two. */
  public void setTime(double component, double hardware, double stub) {
    time = new ProcessingTime(component, hardware, stub);
  }

  /** Records the value of an output. */
  public void record(String output, @Nullable Object value) {
    actual.put(output, Literals.of(value));
  }

  /**
   * Records a part of an output; {@code null} when the value has no such part.
   *
   * @param output name of the part, such as {@code pose.x} or {@code path[3]}
   * @param whole the value of the output
   */
  public void recordPart(String output, @Nullable Object whole) {
    record(output, Parts.of(whole, output).orElse(null));
  }

  /** Records that a method without a return value returned. */
  public void recordReturn(String output) {
    record(output, null);
  }

  /** The literal of a value as in records. */
  public static String literal(@Nullable Object value) {
    return Literals.of(value);
  }

  /**
   * Records a call of a required interface.
   *
   * @param method {@code Interface.Method}
   * @param arguments literals, one for each of the parameters
   */
  public void addCall(String method, List<String> parameters, List<String> arguments) {
    calls.add(new Call(method, parameters, arguments));
  }

  /** Counts calls that are not recorded. */
  public void addCallsLeftOut(long count) {
    callsLeftOut += count;
  }

  /** The literal of a part of a value, or of the value itself if the name has no path. */
  public static String literalOfPart(String name, @Nullable Object whole) {
    return Literals.of(Parts.of(whole, name).orElse(null));
  }

  /**
   * Adds the values of an output data port during the case.
   *
   * @param changes with times since the call
   * @param leftOut number of further changes that are not recorded
   */
  public void addPort(String signal, List<PortChange> changes, long leftOut) {
    ports.add(new Port(signal, List.copyOf(changes), leftOut));
  }

  /** Ends the case with an exception of the call under test. */
  public void threw(Throwable exception, String description) {
    thrown = exception.getClass().getSimpleName();
    endWith(Outcome.THREW, description);
  }

  /** Sets the outcome of a case that did not return; the reason is appended to the message. */
  public void endWith(Outcome newOutcome, String reason) {
    outcome = newOutcome;
    message = message.isEmpty() ? reason : message + "; " + reason;
  }

  /** Ends a step that was stopped before its end; how it reacted to that does not count. */
  public void stopped(String reason) {
    thrown = "";
    message = "";
    endWith(Outcome.ERROR, reason);
  }

  /** Whether the component was called and nothing else failed. */
  public boolean isRepeatable() {
    return outcome == Outcome.RETURNED || outcome == Outcome.THREW;
  }

  /** Sets when a step began: simulation time in nanoseconds since the first step of the case. */
  public void beganAt(long nanos) {
    atNanos = nanos;
  }

  /** From now on, repeated calls of the case are added. */
  public void beginRepeated() {
    repeated = new RepeatedCalls();
  }

  /**
   * Adds a repeated call of the case.
   *
   * @param again the record of the call
   * @param number of the call, from 2
   * @param measured whether its time counts
   */
  public void addRepeated(CaseResult again, int number, boolean measured) {
    RepeatedCalls calls = Objects.requireNonNull(repeated);
    if (!calls.differ()) {
      again.differenceFrom(this).ifPresent(text -> calls.differs("call " + number + ": " + text));
    }
    if (measured && again.time != null && again.outcome == outcome) {
      calls.add(again.time.component());
    }
  }

  /** What this record gives instead of the first one; empty if they give the same. */
  private Optional<String> differenceFrom(CaseResult first) {
    if (outcome != first.outcome || !thrown.equals(first.thrown)) {
      return Optional.of(ending() + ", but the first call " + first.ending());
    }
    for (Map.Entry<String, String> value : actual.entrySet()) {
      String before = first.actual.get(value.getKey());
      if (!value.getValue().equals(before)) {
        return Optional.of(
            value.getKey() + " is " + shortened(value.getValue()) + ", not " + shortened(before));
      }
    }
    return Optional.empty();
  }

  private String ending() {
    return switch (outcome) {
      case RETURNED -> "returned";
      case THREW -> "threw " + shortened(thrown);
      case ERROR, NOT_CALLED -> "failed: " + shortened(message);
    };
  }

  private static String shortened(@Nullable String text) {
    String whole = String.valueOf(text);
    return whole.length() <= MAX_DIFFERENCE ? whole : whole.substring(0, MAX_DIFFERENCE) + "...";
  }

  /** The record as one line of XML that ends with a line feed. */
  String line() {
    RecordLine line =
        testCase instanceof TestStep step
            ? new RecordLine(step, outcome, atNanos)
            : new RecordLine(testCase.no(), outcome);
    if (outcome == Outcome.THREW) {
      line.thrown(thrown);
    }
    actual.forEach(line::actual);
    for (Call call : calls) {
      line.call(call.method(), call.parameters(), call.arguments());
    }
    if (callsLeftOut > 0) {
      line.callsLeftOut(callsLeftOut);
    }
    for (Port port : ports) {
      line.port(port.signal(), port.changes(), port.leftOut());
    }
    if (time != null) {
      line.time(time);
    }
    if (repeated != null) {
      line.repeated(repeated);
    }
    if (!message.isEmpty()) {
      line.message(message);
    }
    return line.close();
  }
}
