package org.sitaf.core.flaky;

import java.util.Arrays;
import java.util.OptionalInt;
import org.sitaf.core.trajectory.Trace;

/**
 * The signals of a case, reduced to two numbers for each sample: one for the commands of the
 * component, one for what the simulator made of them. Equal digests have equal signals, but for
 * collisions of 32 bits.
 */
final class SignalDigest {
  private static final String COMMAND = ".command";

  private final long firstNanos;
  private final long stepNanos;
  private final int[] commands;
  private final int[] states;

  private SignalDigest(long firstNanos, long stepNanos, int[] commands, int[] states) {
    this.firstNanos = firstNanos;
    this.stepNanos = stepNanos;
    this.commands = commands;
    this.states = states;
  }

  static SignalDigest of(Trace trace) {
    int[] commands = new int[trace.count()];
    int[] states = new int[trace.count()];
    for (int column = 0; column < trace.names().size(); column++) {
      int[] digests = trace.names().get(column).endsWith(COMMAND) ? commands : states;
      double[] values = trace.columns().get(column);
      for (int i = 0; i < values.length; i++) {
        digests[i] = 31 * digests[i] + Double.hashCode(values[i]);
      }
    }
    return new SignalDigest(trace.firstNanos(), trace.stepNanos(), commands, states);
  }

  /** The first sample at which the commands differ, among those that both cases have. */
  OptionalInt otherCommands(SignalDigest other) {
    return mismatch(commands, other.commands);
  }

  /** The first sample at which the states of the simulator differ. */
  OptionalInt otherStates(SignalDigest other) {
    return mismatch(states, other.states);
  }

  private static OptionalInt mismatch(int[] one, int[] other) {
    int both = Math.min(one.length, other.length);
    int first = Arrays.mismatch(one, 0, both, other, 0, both);
    return first < 0 ? OptionalInt.empty() : OptionalInt.of(first);
  }

  /** Time of a sample after the call, in seconds. */
  double seconds(int sample) {
    return (firstNanos + sample * stepNanos) / 1e9;
  }
}
