package org.sitaf.core.compare;

import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.verdict.Literals;

/**
 * Compares the literals of one output. Both are untrusted, so the time is limited to a few passes
 * over each.
 *
 * @param type of the output; if unknown, it is derived from the literals
 * @param ulp units in the last place of the largest magnitude that do not count
 */
record OutputComparison(DataType type, int ulp) {
  private static final int MAX_DEPTH = 64;
  private static final Pattern WHOLE = Pattern.compile("[-+]?\\d+");

  /** Ascending by weight. */
  enum Closeness {
    SAME,
    LAST_BITS,
    DIFFERENT
  }

  /**
   * The result of a comparison.
   *
   * @param deviation largest absolute difference of numbers; 0 without one, NaN if something else
   *     than numbers differs
   */
  record Outcome(Closeness closeness, double deviation) {
    static final Outcome SAME = new Outcome(Closeness.SAME, 0);
    static final Outcome OTHER = new Outcome(Closeness.DIFFERENT, Double.NaN);

    Outcome and(Outcome other) {
      return new Outcome(
          closeness.compareTo(other.closeness) >= 0 ? closeness : other.closeness,
          Math.max(deviation, other.deviation));
    }
  }

  /** The magnitude of numbers of this output, of which units in the last place are taken. */
  double magnitude(String literal) {
    return magnitude(literal, type, 0);
  }

  /** Compares the literals by the largest magnitude of both. */
  Outcome compare(String base, String now) {
    return base.equals(now)
        ? Outcome.SAME
        : compare(base, now, Math.max(magnitude(base), magnitude(now)));
  }

  Outcome compare(String base, String now, double magnitude) {
    return compare(base, now, magnitude, type, 0);
  }

  private Outcome compare(String base, String now, double magnitude, DataType of, int depth) {
    if (base.equals(now)) {
      return Outcome.SAME;
    }
    if (depth > MAX_DEPTH) {
      return Outcome.OTHER;
    }
    try {
      if (Literals.isSequence(base) && Literals.isSequence(now) && mayHaveElements(of)) {
        List<String> left = Literals.elements(base);
        List<String> right = Literals.elements(now);
        if (left.size() != right.size()) {
          return Outcome.OTHER;
        }
        Outcome all = Outcome.SAME;
        for (int i = 0; i < left.size(); i++) {
          all = all.and(compare(left.get(i), right.get(i), magnitude, element(of), depth + 1));
        }
        return all;
      }
      if (Literals.isStruct(base) && Literals.isStruct(now) && !(of instanceof DataType.Scalar)) {
        Map<String, String> left = Literals.members(base);
        Map<String, String> right = Literals.members(now);
        if (!left.keySet().equals(right.keySet())) {
          return Outcome.OTHER;
        }
        Outcome all = Outcome.SAME;
        for (Map.Entry<String, String> member : left.entrySet()) {
          String name = member.getKey();
          String other = right.getOrDefault(name, "");
          all = all.and(compare(member.getValue(), other, magnitude, of.member(name), depth + 1));
        }
        return all;
      }
    } catch (IllegalArgumentException e) {
      return Outcome.OTHER;
    }
    return isReal(base, of) && isReal(now, of)
        ? compareNumbers(base, now, magnitude, of)
        : Outcome.OTHER;
  }

  private Outcome compareNumbers(String base, String now, double magnitude, DataType of) {
    double left = Literals.real(base);
    double right = Literals.real(now);
    if (!isFloating(base, of) && !isFloating(now, of)) {
      // Different literals of whole numbers; large ones may be the same double.
      return base.strip().equals(now.strip())
          ? Outcome.SAME
          : new Outcome(Closeness.DIFFERENT, Math.abs(left - right));
    }
    boolean single = isSingle(of);
    return compareNumbers(
        single ? (float) left : left,
        single ? (float) right : right,
        unit(magnitude, single) * ulp);
  }

  private static double unit(double magnitude, boolean single) {
    return single ? Math.ulp((float) Math.min(magnitude, Float.MAX_VALUE)) : Math.ulp(magnitude);
  }

  /**
   * Compares two numbers.
   *
   * @param allowed the absolute difference that does not count
   */
  static Outcome compareNumbers(double base, double now, double allowed) {
    if (Double.compare(base, now) == 0) {
      return Outcome.SAME;
    }
    double difference = Math.abs(base - now);
    if (difference <= allowed) {
      return new Outcome(Closeness.LAST_BITS, difference);
    }
    return new Outcome(Closeness.DIFFERENT, Double.isFinite(difference) ? difference : Double.NaN);
  }

  private double magnitude(String literal, DataType of, int depth) {
    if (depth > MAX_DEPTH) {
      return 0;
    }
    double largest = 0;
    try {
      if (Literals.isSequence(literal) && mayHaveElements(of)) {
        for (String element : Literals.elements(literal)) {
          largest = Math.max(largest, magnitude(element, element(of), depth + 1));
        }
        return largest;
      }
      if (Literals.isStruct(literal) && !(of instanceof DataType.Scalar)) {
        for (Map.Entry<String, String> member : Literals.members(literal).entrySet()) {
          largest =
              Math.max(
                  largest, magnitude(member.getValue(), of.member(member.getKey()), depth + 1));
        }
        return largest;
      }
    } catch (IllegalArgumentException e) {
      return 0;
    }
    if (!isReal(literal, of) || !isFloating(literal, of)) {
      return 0;
    }
    double number = Math.abs(Literals.real(literal));
    return Double.isFinite(number) ? number : 0;
  }

  private static boolean mayHaveElements(DataType of) {
    return !(of instanceof DataType.Scalar || of instanceof DataType.Struct);
  }

  private static DataType element(DataType of) {
    return of.parts().isEmpty() ? new DataType.Unknown("") : of.parts().get(0);
  }

  private static boolean isReal(String literal, DataType of) {
    boolean maybe =
        of instanceof DataType.Unknown
            || of instanceof DataType.Scalar scalar && scalar.type().isNumeric();
    return maybe && Literals.isReal(literal);
  }

  /** Of an unknown type, numbers that are written as whole ones are whole. */
  private static boolean isFloating(String literal, DataType of) {
    return of instanceof DataType.Scalar scalar
        ? scalar.type().isFloating()
        : !WHOLE.matcher(literal.strip()).matches();
  }

  private static boolean isSingle(DataType of) {
    return of instanceof DataType.Scalar scalar && scalar.type() == ScalarType.FLOAT;
  }
}
