package org.sitaf.core.expression.function;

import com.google.common.primitives.UnsignedLong;
import dev.cel.common.values.CelByteString;
import java.math.BigDecimal;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The comparison operators. Whole and floating-point numbers are compared by their exact values; as
 * in IEEE 754, NaN differs from every number and is in no order, and -0.0 equals 0. CEL's own
 * operators treat NaN as greater than each whole number, and -0.0 as less than 0.
 */
final class Comparisons {
  /** Whole numbers up to this magnitude are floating-point numbers. */
  private static final long MAX_EXACT = 1L << 53;

  private static final double TWO_TO_63 = 0x1p63;

  private Comparisons() {}

  static Object less(Object a, Object b) {
    Integer order = order("<", a, b);
    return order != null && order < 0;
  }

  static Object lessEquals(Object a, Object b) {
    Integer order = order("<=", a, b);
    return order != null && order <= 0;
  }

  static Object greater(Object a, Object b) {
    Integer order = order(">", a, b);
    return order != null && order > 0;
  }

  static Object greaterEquals(Object a, Object b) {
    Integer order = order(">=", a, b);
    return order != null && order >= 0;
  }

  static Object equals(Object a, Object b) {
    return areEqual(a, b);
  }

  static Object notEquals(Object a, Object b) {
    return !areEqual(a, b);
  }

  /** Whether a list has an element, or a map a key. */
  static Object isMember(Object value, Object container) {
    if (container instanceof List<?> list) {
      return list.stream().anyMatch(element -> areEqual(value, element));
    }
    if (container instanceof Map<?, ?> map) {
      return key(value, map) != null;
    }
    throw new IllegalArgumentException("in needs a list or a map, not " + Numbers.shown(container));
  }

  private static boolean areEqual(@Nullable Object a, @Nullable Object b) {
    if (a == null || b == null) {
      return a == b;
    }
    if (Numbers.isNumber(a) && Numbers.isNumber(b)) {
      Integer order = numbers(a, b);
      return order != null && order == 0;
    }
    if (a instanceof List<?> left && b instanceof List<?> right) {
      return areEqual(left, right);
    }
    if (a instanceof Map<?, ?> left && b instanceof Map<?, ?> right) {
      return areEqual(left, right);
    }
    return a.equals(b);
  }

  private static boolean areEqual(List<?> left, List<?> right) {
    if (left.size() != right.size()) {
      return false;
    }
    for (int i = 0; i < left.size(); i++) {
      if (!areEqual(left.get(i), right.get(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean areEqual(Map<?, ?> left, Map<?, ?> right) {
    if (left.size() != right.size()) {
      return false;
    }
    for (Map.Entry<?, ?> entry : left.entrySet()) {
      Object key = key(entry.getKey(), right);
      if (key == null || !areEqual(entry.getValue(), right.get(key))) {
        return false;
      }
    }
    return true;
  }

  /** The key of a map that equals a value; null if there is none. */
  private static @Nullable Object key(Object value, Map<?, ?> map) {
    if (map.containsKey(value)) {
      return value;
    }
    if (!Numbers.isNumber(value)) {
      return null;
    }
    for (Object key : map.keySet()) {
      if (areEqual(value, key)) {
        return key;
      }
    }
    return null;
  }

  /** Negative, 0 or positive; null if one of the operands is NaN. */
  private static @Nullable Integer order(String operator, Object a, Object b) {
    if (Numbers.isNumber(a) && Numbers.isNumber(b)) {
      return numbers(a, b);
    }
    if (a instanceof String left && b instanceof String right) {
      return left.compareTo(right);
    }
    if (a instanceof Boolean left && b instanceof Boolean right) {
      return left.compareTo(right);
    }
    if (a instanceof CelByteString left && b instanceof CelByteString right) {
      return CelByteString.unsignedLexicographicalComparator().compare(left, right);
    }
    if (a instanceof Duration left && b instanceof Duration right) {
      return left.compareTo(right);
    }
    if (a instanceof Instant left && b instanceof Instant right) {
      return left.compareTo(right);
    }
    throw new IllegalArgumentException(
        operator + " does not apply to " + Numbers.shown(a) + " and " + Numbers.shown(b));
  }

  private static @Nullable Integer numbers(Object a, Object b) {
    if (a instanceof Double left && b instanceof Double right) {
      return reals(left, right);
    }
    if (a instanceof Long left && b instanceof Long right) {
      return Long.compare(left, right);
    }
    if (a instanceof Double left) {
      return b instanceof Long right ? mixed(left, right) : mixed(left, (UnsignedLong) b);
    }
    if (b instanceof Double right) {
      Integer order = a instanceof Long left ? mixed(right, left) : mixed(right, (UnsignedLong) a);
      return order == null ? null : Integer.valueOf(-order);
    }
    return Arithmetic.big(a).compareTo(Arithmetic.big(b));
  }

  private static @Nullable Integer reals(double a, double b) {
    if (Double.isNaN(a) || Double.isNaN(b)) {
      return null;
    }
    return a < b ? -1 : a > b ? 1 : 0;
  }

  private static @Nullable Integer mixed(double real, long whole) {
    if (Math.abs(real) < TWO_TO_63 && (whole > MAX_EXACT || whole < -MAX_EXACT)) {
      // A fraction is below 2^53 in magnitude, where it does not matter.
      return Long.compare((long) real, whole);
    }
    return reals(real, whole);
  }

  private static @Nullable Integer mixed(double real, UnsignedLong whole) {
    return whole.bigIntegerValue().bitLength() < Long.SIZE
        ? mixed(real, whole.longValue())
        : Double.isNaN(real) || Double.isInfinite(real)
            ? reals(real, 0)
            : Integer.valueOf(
                new BigDecimal(real).compareTo(new BigDecimal(whole.bigIntegerValue())));
  }
}
