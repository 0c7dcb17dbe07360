package org.sitaf.core.trajectory;

/**
 * A closed interval of times relative to a sample, in seconds.
 *
 * @param from 0 or more, finite
 * @param to at least {@code from}; infinite if the operator has no interval
 */
record Interval(double from, double to) {
  /** The interval of an operator without one. */
  static final Interval UNBOUNDED = new Interval(0, Double.POSITIVE_INFINITY);

  /** The current sample only. */
  static final Interval NOW = new Interval(0, 0);

  /** Samples this close to a bound are within the interval, in seconds. */
  static final double TOLERANCE = 1e-9;

  /** A number of steps that is larger than that of any trace. */
  static final int UNBOUNDED_STEPS = Integer.MAX_VALUE / 4;

  Interval {
    if (!(from >= 0) || Double.isInfinite(from) || !(to >= from)) {
      throw new IllegalArgumentException("an interval [" + from + ", " + to + "] is not possible");
    }
  }

  /** The smallest interval that contains both. */
  Interval hull(Interval other) {
    return new Interval(Math.min(from, other.from), Math.max(to, other.to));
  }

  /** The number of steps to the first sample of the interval. */
  int firstStep(long stepNanos) {
    long steps = approximately(from, stepNanos);
    if (steps >= UNBOUNDED_STEPS) {
      return UNBOUNDED_STEPS;
    }
    while (steps > 0 && seconds(steps - 1, stepNanos) >= from - TOLERANCE) {
      steps--;
    }
    while (seconds(steps, stepNanos) < from - TOLERANCE) {
      steps++;
    }
    return (int) steps;
  }

  /** The number of steps to the last sample of the interval. */
  int lastStep(long stepNanos) {
    long steps = approximately(to, stepNanos);
    if (steps >= UNBOUNDED_STEPS) {
      return UNBOUNDED_STEPS;
    }
    while (seconds(steps, stepNanos) > to + TOLERANCE) {
      steps--;
    }
    while (seconds(steps + 1, stepNanos) <= to + TOLERANCE) {
      steps++;
    }
    return (int) steps;
  }

  private static long approximately(double seconds, long stepNanos) {
    return (long) Math.min(UNBOUNDED_STEPS, seconds * 1e9 / stepNanos);
  }

  private static double seconds(long steps, long stepNanos) {
    return steps * stepNanos / 1e9;
  }
}
