package org.sitaf.core.verdict;

import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Tolerance;

/**
 * Compares a value as results spell it with the literal that is expected (docs/test-application.md,
 * Comparison). Both literals come from others: no spelling costs more than a few passes over it.
 *
 * @param type of the output; where that is unknown, the spelling decides
 */
record RecordedValue(DataType type, Tolerance tolerance) {
  /** A value of which nothing is known. */
  static final RecordedValue UNTYPED = new RecordedValue(new DataType.Unknown(""), Tolerance.EXACT);

  private static final int MAX_DEPTH = 64;
  private static final int MAX_SHOWN = 200;

  /** A whole number of more digits fits no type. */
  private static final int MAX_DIGITS = 400;

  RecordedValue {
    Objects.requireNonNull(type);
    Objects.requireNonNull(tolerance);
  }

  /** The first difference in words; empty where the value is as expected. */
  Optional<String> difference(String expected, String actual) {
    try {
      return Optional.ofNullable(difference("", expected, actual, type, 0));
    } catch (IllegalArgumentException e) {
      return Optional.of("what is expected cannot be compared with it: " + e.getMessage());
    }
  }

  private @Nullable String difference(
      String way, String expected, String actual, DataType of, int depth) {
    if (expected.equals(actual)) {
      return null;
    }
    if (depth > MAX_DEPTH) {
      throw new IllegalArgumentException("it is nested more than " + MAX_DEPTH + " deep");
    }
    if (of instanceof DataType.Sequence sequence) {
      return elements(way, expected, actual, sequence.element(), depth);
    }
    if (of instanceof DataType.FixedArray array) {
      return elements(way, expected, actual, array.element(), depth);
    }
    if (of instanceof DataType.Struct) {
      return members(way, expected, actual, of, depth);
    }
    boolean same;
    if (of instanceof DataType.Scalar scalar) {
      same = isSame(expected, actual, scalar.type());
    } else if (of instanceof DataType.Enumeration) {
      same = expected.strip().equals(actual.strip());
    } else if (Literals.isSequence(expected) && Literals.isSequence(actual)) {
      return elements(way, expected, actual, of, depth);
    } else if (Literals.isStruct(expected) && Literals.isStruct(actual)) {
      return members(way, expected, actual, of, depth);
    } else {
      same = isSame(expected, actual, ScalarType.DOUBLE);
    }
    return same ? null : unequal(way, expected, actual);
  }

  private @Nullable String elements(
      String way, String expected, String actual, DataType element, int depth) {
    if (!Literals.isSequence(actual)) {
      return unequal(way, expected, actual);
    }
    List<String> wanted = Literals.elements(expected);
    List<String> got = Literals.elements(actual);
    for (int i = 0; i < Math.min(wanted.size(), got.size()); i++) {
      String found = difference(way + "[" + i + "]", wanted.get(i), got.get(i), element, depth + 1);
      if (found != null) {
        return found;
      }
    }
    return wanted.size() == got.size()
        ? null
        : at(way) + "expected " + wanted.size() + " elements, but there are " + got.size();
  }

  private @Nullable String members(
      String way, String expected, String actual, DataType struct, int depth) {
    if (!Literals.isStruct(actual)) {
      return unequal(way, expected, actual);
    }
    Map<String, String> got = Literals.members(actual);
    for (Map.Entry<String, String> wanted : Literals.members(expected).entrySet()) {
      String name = wanted.getKey();
      String value = got.get(name);
      String found =
          value == null
              ? at(way + "." + name) + "expected " + wanted.getValue() + ", but there is none"
              : difference(
                  way + "." + name, wanted.getValue(), value, struct.member(name), depth + 1);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  private boolean isSame(String expected, String actual, ScalarType scalar) {
    if (scalar == ScalarType.BOOLEAN || Literals.isTruth(actual)) {
      return Literals.isTruth(actual) && Literals.truth(expected).equals(Literals.truth(actual));
    }
    if (scalar.isInteger() && Literals.isNumber(expected) && Literals.isNumber(actual)) {
      return isSameWhole(expected.strip(), actual.strip());
    }
    if (scalar.isNumeric()) {
      return isSameReal(expected, actual, scalar == ScalarType.FLOAT);
    }
    return ReportedCase.spelledOut(expected).equals(actual) || expected.strip().equals(actual);
  }

  private boolean isSameWhole(String expected, String actual) {
    BigDecimal wanted = whole(expected);
    BigDecimal apart = whole(actual).subtract(wanted).abs();
    BigDecimal allowed =
        new BigDecimal(tolerance.absolute())
            .add(new BigDecimal(tolerance.relative()).multiply(wanted.abs()));
    return apart.compareTo(allowed) <= 0;
  }

  /** Such a number as {@code 1e999999999} would take all memory. */
  private static BigDecimal whole(String literal) {
    BigDecimal number = new BigDecimal(literal);
    if ((long) literal.length() + Math.abs((long) number.scale()) > MAX_DIGITS) {
      throw new IllegalArgumentException(
          "'" + shortened(literal) + "' has more digits than any number of a test");
    }
    return number;
  }

  private boolean isSameReal(String expected, String actual, boolean single) {
    if (!Literals.isReal(expected) || !Literals.isReal(actual)) {
      return false;
    }
    double wanted = single ? (float) Literals.real(expected) : Literals.real(expected);
    double got = single ? (float) Literals.real(actual) : Literals.real(actual);
    if (Double.isNaN(wanted) && Double.isNaN(got) || wanted == got) {
      return true;
    }
    double unit = single ? Math.ulp((float) wanted) : Math.ulp(wanted);
    double allowed =
        tolerance.absolute() + tolerance.relative() * Math.abs(wanted) + tolerance.ulp() * unit;
    return Double.isFinite(wanted) && Double.isFinite(got) && Math.abs(got - wanted) <= allowed;
  }

  private static String at(String way) {
    return way.isEmpty() ? "" : way + ": ";
  }

  private static String unequal(String way, String expected, String actual) {
    return at(way) + "expected " + shortened(expected) + ", but was " + shortened(actual);
  }

  /** The beginning of a literal, as a message shows it. */
  static String shortened(String literal) {
    return literal.length() <= MAX_SHOWN
        ? literal
        : literal.substring(0, MAX_SHOWN) + " ... (" + literal.length() + " characters)";
  }
}
