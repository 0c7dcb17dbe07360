package org.sitaf.agent.build;

import java.util.List;
import org.sitaf.core.trajectory.ConditionSpan;

/**
 * The signals of a case for a plot: those that the trajectory conditions use, at a limited number
 * of samples.
 *
 * @param samples number of samples of the case
 * @param nanos times of the samples that remain, relative to the call, ascending
 * @param conditions where the trajectory conditions apply
 */
@SuppressWarnings("ArrayRecordComponent") // Excerpts are not compared.
public record SignalExcerpt(
    int samples, long[] nanos, List<Signal> signals, List<ConditionSpan> conditions) {
  public SignalExcerpt {
    signals = List.copyOf(signals);
    conditions = List.copyOf(conditions);
  }

  /**
   * A signal.
   *
   * @param unit empty if it is not known
   * @param values one per time
   */
  @SuppressWarnings("ArrayRecordComponent")
  public record Signal(String name, String unit, double[] values) {}

  /** Size of its numbers in bytes. */
  long bytes() {
    return (long) nanos.length * (Long.BYTES + Double.BYTES * (long) signals.size());
  }
}
