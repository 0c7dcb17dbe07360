package org.sitaf.core.compare;

import java.util.Optional;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.OutputComparison.Closeness;
import org.sitaf.core.trajectory.Trace;

/**
 * The first step at which two traces diverge.
 *
 * @param signal the first signal in the order of the traces that differs at that step; {@link
 *     #TIME} if one trace ends earlier
 * @param seconds after the call
 * @param lastBits whether the traces differ nowhere by more than the last bits
 */
record SignalDivergence(String signal, double seconds, double base, double now, boolean lastBits) {
  /** The signal that both traces have. */
  static final String TIME = "t";

  /**
   * The first divergence of the signals that both traces have; the later part of a trace counts if
   * the other one ends earlier. Empty if there is none.
   *
   * @param selected the compared signals
   * @param ulp units in the last place of the largest magnitude of a signal that do not count
   */
  static Optional<SignalDivergence> of(
      Trace base, Trace now, Predicate<String> selected, boolean withEnd, int ulp) {
    long step = base.stepNanos();
    long first = Math.max(base.firstNanos(), now.firstNanos());
    int inBase = (int) ((first - base.firstNanos()) / step);
    int inNow = (int) ((first - now.firstNanos()) / step);
    int count = Math.min(base.count() - inBase, now.count() - inNow);
    int earliest = count;
    int earliestBits = count;
    @Nullable SignalDivergence found = null;
    @Nullable SignalDivergence bits = null;
    for (int i = 0; i < base.names().size(); i++) {
      String name = base.names().get(i);
      int other = now.names().indexOf(name);
      if (other < 0 || !selected.test(name)) {
        continue;
      }
      double[] left = base.columns().get(i);
      double[] right = now.columns().get(other);
      double allowed = Math.ulp(Math.max(magnitude(left), magnitude(right))) * ulp;
      for (int k = 0; k < earliest; k++) {
        double a = left[inBase + k];
        double b = right[inNow + k];
        Closeness closeness = OutputComparison.compareNumbers(a, b, allowed).closeness();
        if (closeness == Closeness.DIFFERENT) {
          earliest = k;
          found = new SignalDivergence(name, base.seconds(inBase + k), a, b, false);
        } else if (closeness == Closeness.LAST_BITS && k < earliestBits) {
          earliestBits = k;
          bits = new SignalDivergence(name, base.seconds(inBase + k), a, b, true);
        }
      }
    }
    int ofBase = base.count() - inBase;
    int ofNow = now.count() - inNow;
    if (found == null && withEnd && ofBase != ofNow) {
      return Optional.of(
          new SignalDivergence(
              TIME,
              base.seconds(inBase + count - 1),
              base.seconds(base.count() - 1),
              now.seconds(now.count() - 1),
              false));
    }
    return Optional.ofNullable(found == null ? bits : found);
  }

  private static double magnitude(double[] column) {
    double largest = 0;
    for (double number : column) {
      double size = Math.abs(number);
      if (size > largest && size < Double.POSITIVE_INFINITY) {
        largest = size;
      }
    }
    return largest;
  }
}
