package org.sitaf.core.model.document;

import java.math.BigDecimal;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Decimals;

/** Parses the settings of a {@code test_spec}. All throw IllegalArgumentException. */
final class Settings {
  private static final int MAX_COUNT = 1_000_000;

  private Settings() {}

  static void requireNumeric(DataType type) {
    if (type instanceof DataType.Scalar scalar
        && !scalar.type().isNumeric()
        && scalar.type() != ScalarType.BOOLEAN) {
      throw new IllegalArgumentException(
          "generates numbers, but the real_type is " + scalar.typeName());
    }
  }

  static BigDecimal number(String text, DataType type) {
    BigDecimal number = Decimals.parse(text);
    boolean whole = type instanceof DataType.Scalar scalar && scalar.type().isInteger();
    if (whole && number.stripTrailingZeros().scale() > 0) {
      throw new IllegalArgumentException(
          text + " is not a whole number, but the real_type is " + type.typeName());
    }
    return number;
  }

  static BigDecimal positive(String text, DataType type) {
    BigDecimal number = number(text, type);
    if (number.signum() <= 0) {
      throw new IllegalArgumentException("must be greater than 0, not " + text);
    }
    return number;
  }

  static int whole(String text, int least) {
    try {
      int number = Decimals.parse(text).intValueExact();
      if (number >= least && number <= MAX_COUNT) {
        return number;
      }
    } catch (ArithmeticException e) {
      // Reported below.
    }
    throw new IllegalArgumentException(
        "must be a whole number from " + least + " to " + MAX_COUNT + ", not '" + text + "'");
  }

  static boolean parseBoolean(@Nullable String text, boolean otherwise) {
    if (text == null || text.isEmpty()) {
      return otherwise;
    }
    return switch (text) {
      case "true", "1" -> true;
      case "false", "0" -> false;
      default -> throw new IllegalArgumentException("must be true or false, not '" + text + "'");
    };
  }

  static String required(@Nullable String text, String message) {
    if (text == null) {
      throw new IllegalArgumentException(message);
    }
    return text;
  }

  static @Nullable String first(@Nullable String one, @Nullable String other) {
    return one != null ? one : other;
  }

  static String first(@Nullable String one, @Nullable String other, String otherwise) {
    String found = first(one, other);
    return found == null ? otherwise : found;
  }
}
