package org.sitaf.core.expression.function;

import com.google.common.primitives.UnsignedLong;
import dev.cel.common.values.CelByteString;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;

/**
 * The operators over numbers. An operation over whole numbers is whole and exact; if one of the
 * operands is a floating-point number, so is the result.
 */
final class Arithmetic {
  private static final BigInteger MIN = BigInteger.valueOf(Long.MIN_VALUE);
  private static final BigInteger MAX = BigInteger.valueOf(Long.MAX_VALUE);
  private static final BigInteger UNSIGNED_MAX = UnsignedLong.MAX_VALUE.bigIntegerValue();

  private Arithmetic() {}

  static Object add(Object a, Object b) {
    if (a instanceof Double x && b instanceof Double y) {
      return x + y;
    }
    if (a instanceof Long x && b instanceof Long y) {
      return Math.addExact(x, y);
    }
    if (a instanceof String x && b instanceof String y) {
      return x + y;
    }
    if (a instanceof List<?> x && b instanceof List<?> y) {
      List<Object> joined = new ArrayList<>(x.size() + y.size());
      joined.addAll(x);
      joined.addAll(y);
      return joined;
    }
    if (a instanceof CelByteString x && b instanceof CelByteString y) {
      return x.concat(y);
    }
    if (areWhole(a, b)) {
      return narrow(big(a).add(big(b)));
    }
    requireNumbers("+", a, b);
    return Numbers.real(a) + Numbers.real(b);
  }

  static Object subtract(Object a, Object b) {
    if (a instanceof Double x && b instanceof Double y) {
      return x - y;
    }
    if (a instanceof Long x && b instanceof Long y) {
      return Math.subtractExact(x, y);
    }
    if (areWhole(a, b)) {
      return narrow(big(a).subtract(big(b)));
    }
    requireNumbers("-", a, b);
    return Numbers.real(a) - Numbers.real(b);
  }

  static Object multiply(Object a, Object b) {
    if (a instanceof Double x && b instanceof Double y) {
      return x * y;
    }
    if (a instanceof Long x && b instanceof Long y) {
      return Math.multiplyExact(x, y);
    }
    if (areWhole(a, b)) {
      return narrow(big(a).multiply(big(b)));
    }
    requireNumbers("*", a, b);
    return Numbers.real(a) * Numbers.real(b);
  }

  static Object divide(Object a, Object b) {
    if (a instanceof Double x && b instanceof Double y) {
      return x / y;
    }
    if (areWhole(a, b)) {
      if (big(b).signum() == 0) {
        throw new ArithmeticException("division by zero");
      }
      return narrow(big(a).divide(big(b)));
    }
    requireNumbers("/", a, b);
    return Numbers.real(a) / Numbers.real(b);
  }

  static Object modulo(Object a, Object b) {
    if (!areWhole(a, b)) {
      throw new IllegalArgumentException(
          "% needs two whole numbers, not " + Numbers.shown(a) + " and " + Numbers.shown(b));
    }
    if (big(b).signum() == 0) {
      throw new ArithmeticException("modulus by zero");
    }
    return narrow(big(a).remainder(big(b)));
  }

  static Object negate(Object a) {
    if (a instanceof Double x) {
      return -x;
    }
    if (a instanceof Long || a instanceof UnsignedLong) {
      return narrow(big(a).negate());
    }
    throw new IllegalArgumentException("- needs a number, not " + Numbers.shown(a));
  }

  private static boolean areWhole(Object a, Object b) {
    return Numbers.isWhole(a) && Numbers.isWhole(b);
  }

  static BigInteger big(Object whole) {
    return whole instanceof UnsignedLong unsigned
        ? unsigned.bigIntegerValue()
        : BigInteger.valueOf((Long) whole);
  }

  private static Object narrow(BigInteger number) {
    if (number.compareTo(MIN) >= 0 && number.compareTo(MAX) <= 0) {
      return number.longValue();
    }
    if (number.signum() > 0 && number.compareTo(UNSIGNED_MAX) <= 0) {
      return UnsignedLong.valueOf(number);
    }
    throw new ArithmeticException("the whole number " + number + " has more than 64 bits");
  }

  private static void requireNumbers(String operator, Object a, Object b) {
    if (!Numbers.isNumber(a) || !Numbers.isNumber(b)) {
      throw new IllegalArgumentException(
          operator + " does not apply to " + Numbers.shown(a) + " and " + Numbers.shown(b));
    }
  }
}
