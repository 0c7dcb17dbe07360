package org.sitaf.core.model;

/**
 * How far an actual number may lie from the expected one: {@code |actual - expected| <= absolute +
 * relative * |expected|}.
 *
 * @param absolute in the unit of the output, not negative
 * @param relative a fraction, not negative
 */
public record Tolerance(double absolute, double relative) {
  /** Equal, as numbers. */
  public static final Tolerance EXACT = new Tolerance(0, 0);

  public Tolerance {
    if (!(absolute >= 0) || !(relative >= 0)) {
      throw new IllegalArgumentException("a tolerance must be 0 or more");
    }
  }
}
