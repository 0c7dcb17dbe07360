package org.sitaf.core.model;

import java.math.BigDecimal;

/** Parses decimal numbers of documents. */
public final class Decimals {
  /**
   * Maximum number of digits before and after the point, so hostile input such as 1e999999999
   * cannot exhaust memory.
   */
  private static final int MAX_DIGITS = 400;

  private Decimals() {}

  /**
   * Parses a finite number exactly.
   *
   * @throws IllegalArgumentException if the text is not a number or has too many digits
   */
  public static BigDecimal parse(String text) {
    try {
      BigDecimal number = new BigDecimal(text.strip());
      long integerDigits = (long) number.precision() - number.scale();
      if (Math.abs((long) number.scale()) <= MAX_DIGITS
          && integerDigits <= MAX_DIGITS
          && number.precision() <= MAX_DIGITS) {
        return number;
      }
    } catch (NumberFormatException e) {
      // Reported below.
    }
    throw new IllegalArgumentException("'" + text + "' is not a number");
  }
}
