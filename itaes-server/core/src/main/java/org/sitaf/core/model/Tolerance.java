package org.sitaf.core.model;

/**
 * The allowed difference between an actual and an expected number: {@code |actual - expected| <=
 * absolute + relative * |expected| + ulp * u}, where u is the distance from the expected number to
 * the next floating-point number.
 *
 * @param absolute in the unit of the output, not negative
 * @param relative fraction of the expected number, not negative
 * @param ulp units in the last place, not negative; ignored for integers
 */
public record Tolerance(double absolute, double relative, double ulp) {
  /** The numbers must be equal. */
  public static final Tolerance EXACT = new Tolerance(0, 0, 0);

  public Tolerance {
    if (!(absolute >= 0) || !(relative >= 0) || !(ulp >= 0)) {
      throw new IllegalArgumentException("a tolerance must be 0 or more");
    }
  }
}
