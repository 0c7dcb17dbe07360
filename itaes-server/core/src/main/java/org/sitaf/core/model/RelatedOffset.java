package org.sitaf.core.model;

import java.math.BigDecimal;
import java.util.Objects;

/**
 * The distance of a related value from the value that it follows.
 *
 * @param amount steps, percent or a number, by unit
 */
public record RelatedOffset(Unit unit, BigDecimal amount) {
  private static final BigDecimal MAX_STEPS = BigDecimal.valueOf(1L << 62);

  /** What an offset counts. */
  public enum Unit {
    /** A number of the unit of the parameter; an angle in radians for rotations and directions. */
    NUMBER(""),
    /** Steps to the next number of the type. */
    ULP("ulp"),
    /** Percent of the other value's absolute value. */
    PERCENT("%");

    private final String suffix;

    Unit(String suffix) {
      this.suffix = suffix;
    }
  }

  public RelatedOffset {
    Objects.requireNonNull(unit);
    Objects.requireNonNull(amount);
  }

  /**
   * Parses an entry such as {@code 1e-9}, {@code -1ulp} or {@code 10%}.
   *
   * @throws IllegalArgumentException if it is none of these
   */
  public static RelatedOffset parse(String text) {
    for (Unit unit : new Unit[] {Unit.ULP, Unit.PERCENT}) {
      if (text.endsWith(unit.suffix)) {
        BigDecimal amount = decimal(text.substring(0, text.length() - unit.suffix.length()), text);
        if (unit == Unit.ULP
            && (amount.stripTrailingZeros().scale() > 0 || amount.abs().compareTo(MAX_STEPS) > 0)) {
          throw new IllegalArgumentException("'" + text + "' is not a whole number of steps");
        }
        return new RelatedOffset(unit, amount);
      }
    }
    return new RelatedOffset(Unit.NUMBER, decimal(text, text));
  }

  /** The entry in documents. */
  public String text() {
    return amount + unit.suffix;
  }

  private static BigDecimal decimal(String number, String text) {
    try {
      return Decimals.parse(number);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          "'" + text + "' is not an offset such as 1e-9, -1ulp or 10%", e);
    }
  }
}
