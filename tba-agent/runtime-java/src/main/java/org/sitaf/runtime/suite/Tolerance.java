package org.sitaf.runtime.suite;

/**
 * How far an actual number may lie from the expected one: {@code |actual - expected| <= absolute +
 * relative * |expected| + ulp * u}, where u is the distance from the expected number to the next.
 *
 * @param absolute in the unit of the output, 0 or more
 * @param relative a fraction, 0 or more
 * @param ulp units in the last place, 0 or more; a whole number has none
 */
public record Tolerance(double absolute, double relative, double ulp) {
  /** Equal, as numbers. */
  public static final Tolerance EXACT = new Tolerance(0, 0, 0);

  public Tolerance {
    if (!(absolute >= 0) || !(relative >= 0) || !(ulp >= 0)) {
      throw new IllegalArgumentException(
          "a tolerance is 0 or more, not absolute "
              + absolute
              + ", relative "
              + relative
              + ", ulp "
              + ulp);
    }
  }

  /** A tolerance without units in the last place. */
  public Tolerance(double absolute, double relative) {
    this(absolute, relative, 0);
  }

  /** Whether no difference is tolerated. */
  boolean isExact() {
    return absolute == 0 && relative == 0 && ulp == 0;
  }

  /**
   * The largest difference from an expected value that passes.
   *
   * @param unit distance from the expected number to the next; 0 for a whole number
   */
  double allowed(double expected, double unit) {
    return absolute + relative * Math.abs(expected) + ulp * unit;
  }
}
