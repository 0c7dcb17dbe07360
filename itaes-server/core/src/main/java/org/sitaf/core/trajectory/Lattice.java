package org.sitaf.core.trajectory;

import java.util.List;
import org.sitaf.core.trajectory.Formula.Quantifier;

/**
 * A totally ordered set of truth values with a negation, and the operators of the logic over one
 * value per sample.
 *
 * <p>Intervals of until and since are reduced to windows and unbounded operators (Donzé, Ferrère,
 * Maler: Efficient Robust Monitoring for STL, CAV 2013). All operators take time linear in the
 * number of samples.
 */
final class Lattice {
  private final List<double[]> atoms;
  private final int count;
  private final long stepNanos;
  private final double top;
  private final double beyond;

  /**
   * @param top the greatest value; its negative is the least one
   * @param beyond the value of {@code false} after the end of the trace
   */
  private Lattice(List<double[]> atoms, int count, long stepNanos, double top, double beyond) {
    this.atoms = atoms;
    this.count = count;
    this.stepNanos = stepNanos;
    this.top = top;
    this.beyond = beyond;
  }

  /** Robustness margins: how far a formula is from the other truth value. */
  static Lattice ofMargins(List<AtomValues> atoms, int count, long stepNanos) {
    return new Lattice(
        atoms.stream().map(AtomValues::margins).toList(),
        count,
        stepNanos,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY);
  }

  /**
   * Decisions: truth values with the sample that decides them. A decision is {@code count + 1 - k}
   * if true from sample k on, the negative if false, where k is {@code count} if only the end of
   * the trace decides. These are the three-valued truths of growing prefixes: a maximum is their
   * disjunction, a minimum their conjunction.
   */
  static Lattice ofDecisions(List<AtomValues> atoms, int count, long stepNanos) {
    return new Lattice(
        atoms.stream().map(a -> decisions(a.truths())).toList(), count, stepNanos, count + 1, -1);
  }

  private static double[] decisions(boolean[] truths) {
    double[] values = new double[truths.length];
    for (int k = 0; k < values.length; k++) {
      int decision = values.length + 1 - k;
      values[k] = truths[k] ? decision : -decision;
    }
    return values;
  }

  /** The number of samples. */
  int count() {
    return count;
  }

  /** The step from a sample to the first one of an interval. */
  int first(Interval interval) {
    return interval.firstStep(stepNanos);
  }

  /** The step from a sample to the last one of an interval. */
  int last(Interval interval) {
    return interval.lastStep(stepNanos);
  }

  double[] atom(int index) {
    return atoms.get(index).clone();
  }

  double[] window(Quantifier quantifier, Interval interval, double[] operand) {
    int from = quantifier.isFuture() ? first(interval) : -last(interval);
    int to = quantifier.isFuture() ? last(interval) : -first(interval);
    return quantifier.isUniversal()
        ? SlidingWindow.minimum(operand, from, to, top, -beyond)
        : SlidingWindow.maximum(operand, from, to, -top, beyond);
  }

  double[] until(Interval interval, double[] left, double[] right) {
    int first = first(interval);
    double[] within = SlidingWindow.maximum(right, first, last(interval), -top, beyond);
    double[] unbounded = right;
    double next = beyond;
    for (int k = count - 1; k >= 0; k--) {
      next = Math.max(right[k], Math.min(left[k], next));
      unbounded[k] = next;
    }
    double[] before = SlidingWindow.minimum(left, 0, first - 1, top, top);
    for (int k = 0; k < count; k++) {
      double from = k + first < count ? unbounded[k + first] : beyond;
      within[k] = Math.min(within[k], Math.min(before[k], from));
    }
    return within;
  }

  double[] since(Interval interval, double[] left, double[] right) {
    int first = first(interval);
    double[] within = SlidingWindow.maximum(right, -last(interval), -first, -top, beyond);
    double[] unbounded = right;
    double previous = -top;
    for (int k = 0; k < count; k++) {
      previous = Math.max(right[k], Math.min(left[k], previous));
      unbounded[k] = previous;
    }
    double[] after = SlidingWindow.minimum(left, -first + 1, 0, top, top);
    for (int k = 0; k < count; k++) {
      double from = k >= first ? unbounded[k - first] : -top;
      within[k] = Math.min(within[k], Math.min(after[k], from));
    }
    return within;
  }

  static double[] negative(double[] values) {
    SlidingWindow.negate(values);
    return values;
  }

  static double[] minimum(double[] values, double[] others) {
    for (int k = 0; k < values.length; k++) {
      values[k] = Math.min(values[k], others[k]);
    }
    return values;
  }

  static double[] maximum(double[] values, double[] others) {
    for (int k = 0; k < values.length; k++) {
      values[k] = Math.max(values[k], others[k]);
    }
    return values;
  }
}
