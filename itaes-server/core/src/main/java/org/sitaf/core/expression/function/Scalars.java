package org.sitaf.core.expression.function;

import com.google.common.primitives.UnsignedLong;
import java.util.List;

/**
 * Functions of numbers. Outside of its domain a function gives NaN. StrictMath gives the same bits
 * on every machine.
 */
final class Scalars {
  private static final double TURN = 2 * Math.PI;

  private Scalars() {}

  static Object abs(Object x) {
    if (x instanceof Long number) {
      return Math.absExact(number);
    }
    return x instanceof UnsignedLong ? x : (Object) Math.abs(Numbers.real(x));
  }

  static Object sign(Object x) {
    return Numbers.isWhole(x)
        ? (Object) (long) Arithmetic.big(x).signum()
        : (Object) Math.signum(Numbers.real(x));
  }

  static Object floor(Object x) {
    return Numbers.isWhole(x) ? x : (Object) Math.floor(Numbers.real(x));
  }

  static Object ceil(Object x) {
    return Numbers.isWhole(x) ? x : (Object) Math.ceil(Numbers.real(x));
  }

  /** Rounds halves away from zero. */
  static Object round(Object x) {
    if (Numbers.isWhole(x)) {
      return x;
    }
    double number = Numbers.real(x);
    double size = Math.abs(number);
    double down = Math.floor(size);
    // The difference is exact, but size + 0.5 is not.
    return Math.copySign(size - down >= 0.5 ? down + 1 : down, number);
  }

  /** The limits in the wrong order are outside of the domain. */
  static Object clamp(Object x, Object low, Object high) {
    double l = Numbers.real(low);
    double h = Numbers.real(high);
    if (!(l <= h) || Double.isNaN(Numbers.real(x))) {
      return Double.NaN;
    }
    return least(List.of(greatest(List.of(x, low)), high));
  }

  static Object least(List<?> numbers) {
    return extreme("min", numbers, -1);
  }

  static Object greatest(List<?> numbers) {
    return extreme("max", numbers, 1);
  }

  /**
   * The least or greatest number; NaN if one of them is NaN, or if there are none. It is whole if
   * all of them are.
   */
  private static Object extreme(String function, List<?> numbers, int sign) {
    Object extreme = null;
    boolean whole = true;
    for (Object each : numbers) {
      if (!Numbers.isNumber(each)) {
        throw new IllegalArgumentException(function + " needs numbers, not " + Numbers.shown(each));
      }
      whole &= Numbers.isWhole(each);
      if (extreme == null) {
        extreme = each;
      } else if (Numbers.isWhole(each) && Numbers.isWhole(extreme)) {
        extreme =
            sign * Arithmetic.big(each).compareTo(Arithmetic.big(extreme)) > 0 ? each : extreme;
      } else {
        double a = Numbers.real(extreme);
        double b = Numbers.real(each);
        extreme = sign < 0 ? Math.min(a, b) : Math.max(a, b);
      }
    }
    if (extreme == null) {
      return Double.NaN;
    }
    return whole ? extreme : (Object) Numbers.real(extreme);
  }

  /** Wraps an angle in radians to (-pi, pi]. */
  static double wrapAngle(double angle) {
    double wrapped = StrictMath.IEEEremainder(angle, TURN);
    return wrapped <= -Math.PI ? Math.PI : wrapped;
  }
}
