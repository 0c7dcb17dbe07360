package org.sitaf.core.model;

/**
 * How far an actual number may lie from the expected one: {@code |actual - expected| <= absolute +
 * relative * |expected| + ulp * u}, with u the distance from the expected number to the next.
 *
 * @param absolute in the unit of the output, not negative
 * @param relative a fraction, not negative
 * @param ulp units in the last place, not negative; a whole number has none
 */
public record Tolerance(double absolute, double relative, double ulp) {
  /** Equal, as numbers. */
  public static final Tolerance EXACT = new Tolerance(0, 0, 0);

  public Tolerance {
    if (!(absolute >= 0) || !(relative >= 0) || !(ulp >= 0)) {
      throw new IllegalArgumentException("a tolerance must be 0 or more");
    }
  }
}
