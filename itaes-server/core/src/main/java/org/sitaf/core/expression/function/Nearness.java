package org.sitaf.core.expression.function;

import java.math.BigDecimal;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Compares values by the rule of {@link org.sitaf.core.model.Tolerance}: {@code |a - b| <= absolute
 * + relative * |b|} for each number in them. NaN is near NaN. Everything else in them must be
 * equal. Of a struct, the members of b count.
 */
record Nearness(double absolute, double relative) {
  private static final int MAX_DEPTH = 100;

  Nearness {
    if (!(absolute >= 0) || !(relative >= 0)) {
      throw new IllegalArgumentException(
          "near needs tolerances of 0 or more, not " + absolute + " and " + relative);
    }
  }

  static boolean near(Object a, Object b, Object absolute, Object relative) {
    return new Nearness(Numbers.real(absolute), Numbers.real(relative)).near(a, b, 0);
  }

  private boolean near(Object a, Object b, int depth) {
    if (depth > MAX_DEPTH) {
      throw new IllegalArgumentException(
          "near compares values of at most " + MAX_DEPTH + " nested levels");
    }
    if (Numbers.isNumber(a) && Numbers.isNumber(b)) {
      return nearNumbers(a, b);
    }
    if (a instanceof List<?> first && b instanceof List<?> second) {
      if (first.size() != second.size()) {
        return false;
      }
      Iterator<?> others = second.iterator();
      for (Object each : first) {
        if (!near(each, others.next(), depth + 1)) {
          return false;
        }
      }
      return true;
    }
    if (a instanceof Map<?, ?> first && b instanceof Map<?, ?> second) {
      for (Map.Entry<?, ?> member : second.entrySet()) {
        Object other = first.get(member.getKey());
        if (other == null || !near(other, member.getValue(), depth + 1)) {
          return false;
        }
      }
      return true;
    }
    return Objects.equals(a, b);
  }

  private boolean nearNumbers(Object a, Object b) {
    if (Numbers.isWhole(a) && Numbers.isWhole(b) && Double.isFinite(absolute + relative)) {
      BigDecimal expected = new BigDecimal(Arithmetic.big(b));
      BigDecimal allowed =
          new BigDecimal(absolute).add(new BigDecimal(relative).multiply(expected.abs()));
      return new BigDecimal(Arithmetic.big(a)).subtract(expected).abs().compareTo(allowed) <= 0;
    }
    double actual = Numbers.real(a);
    double expected = Numbers.real(b);
    if (Double.isNaN(actual) && Double.isNaN(expected) || actual == expected) {
      return true;
    }
    if (!Double.isFinite(actual) || !Double.isFinite(expected)) {
      return false;
    }
    return Math.abs(actual - expected) <= absolute + relative * Math.abs(expected);
  }
}
