package org.sitaf.core.model;

import java.math.BigDecimal;

/** Decimal numbers as documents write them. */
final class Decimals {
  /**
   * No number of a robot has more digits before or after the point; larger ones would only exhaust
   * memory.
   */
  private static final int MAX_DIGITS = 400;

  private Decimals() {}

  /**
   * Reads a finite number exactly.
   *
   * @throws IllegalArgumentException when it is none
   */
  static BigDecimal parse(String text) {
    try {
      BigDecimal number = new BigDecimal(text.strip());
      long integerDigits = (long) number.precision() - number.scale();
      if (Math.abs((long) number.scale()) <= MAX_DIGITS
          && integerDigits <= MAX_DIGITS
          && number.precision() <= MAX_DIGITS) {
        return number;
      }
    } catch (NumberFormatException e) {
      // Told below, with every other text that is not a usable number.
    }
    throw new IllegalArgumentException("'" + text + "' is not a number");
  }
}
