package org.sitaf.core.model;

import java.math.BigDecimal;

/** Parses decimal numbers of documents. */
public final class Decimals {
  /**
   * Maximum number of digits before and after the point, so hostile input such as 1e999999999
   * cannot exhaust memory.
   */
  private static final int MAX_DIGITS = 400;

  /** Digits before and after the point, sign and exponent; parsing takes quadratic time. */
  private static final int MAX_LENGTH = 2 * MAX_DIGITS + 20;

  private static final int SHOWN = 20;

  private Decimals() {}

  /**
   * Parses a finite number exactly.
   *
   * @throws IllegalArgumentException if the text is not a number or has too many digits
   */
  public static BigDecimal parse(String text) {
    String literal = text.strip();
    if (literal.length() > MAX_LENGTH) {
      throw new IllegalArgumentException(
          "'%s...' has more than %d characters and is not a number"
              .formatted(literal.substring(0, SHOWN), MAX_LENGTH));
    }
    try {
      BigDecimal number = new BigDecimal(literal);
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
