package org.sitaf.runtime.suite;

/**
 * How far an actual number may lie from the expected one: {@code |actual - expected| <= absolute +
 * relative * |expected|}.
 *
 * @param absolute in the unit of the output, 0 or more
 * @param relative a fraction, 0 or more
 */
public record Tolerance(double absolute, double relative) {
  /** Equal, as numbers. */
  public static final Tolerance EXACT = new Tolerance(0, 0);

  public Tolerance {
    if (!(absolute >= 0) || !(relative >= 0)) {
      throw new IllegalArgumentException(
          "a tolerance is 0 or more, not absolute " + absolute + ", relative " + relative);
    }
  }

  /** Whether no difference is tolerated. */
  boolean isExact() {
    return absolute == 0 && relative == 0;
  }

  /** The largest difference from an expected value that passes. */
  double allowed(double expected) {
    return absolute + relative * Math.abs(expected);
  }
}
