package org.sitaf.core.expression.function;

import com.google.common.primitives.UnsignedLong;
import java.util.List;
import java.util.Map;

/** Numbers of expressions: Long, UnsignedLong and Double. */
final class Numbers {
  private static final int MAX_SHOWN = 100;

  private Numbers() {}

  static boolean isWhole(Object value) {
    return value instanceof Long || value instanceof UnsignedLong;
  }

  static boolean isNumber(Object value) {
    return value instanceof Double || isWhole(value);
  }

  /**
   * The nearest floating-point number.
   *
   * @throws IllegalArgumentException if it is not a number
   */
  static double real(Object value) {
    if (value instanceof Double number) {
      return number;
    }
    if (value instanceof Long number) {
      return number.doubleValue();
    }
    if (value instanceof UnsignedLong number) {
      return number.doubleValue();
    }
    throw new IllegalArgumentException("needs a number, not " + shown(value));
  }

  /** A value for a message. */
  static String shown(Object value) {
    if (value instanceof List<?> list && list.size() > 10) {
      return "a list of " + list.size() + " elements";
    }
    String text =
        value instanceof String string
            ? '"' + string + '"'
            : value instanceof List<?> || value instanceof Map<?, ?>
                ? String.valueOf(value).replace('=', ':')
                : String.valueOf(value);
    return text.length() <= MAX_SHOWN ? text : text.substring(0, MAX_SHOWN) + "…";
  }
}
