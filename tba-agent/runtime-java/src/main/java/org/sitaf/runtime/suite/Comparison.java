package org.sitaf.runtime.suite;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Compares the value of an output with the literal that is expected.
 *
 * <ul>
 *   <li>Numbers compare as numbers within the tolerance: {@code -1} equals {@code -1.0}. NaN equals
 *       NaN, an infinity only itself, and a tolerance never makes an infinity of a finite number.
 *   <li>For a {@code float} the expected number is first rounded to one: {@code 0.1} is expected as
 *       {@code 0.1f}.
 *   <li>Sequences compare element by element, structs by the members that are expected; strings,
 *       characters and booleans have no tolerance.
 * </ul>
 */
final class Comparison {
  private Comparison() {}

  /**
   * The first difference.
   *
   * @param way to it within the value, such as {@code [3].x}; empty for the value itself
   * @param text what differs, in words
   */
  record Difference(String way, String text) {
    private Difference within(String step) {
      return new Difference(step + way, text);
    }
  }

  /** The first difference; empty when the actual value is as expected. */
  static Optional<Difference> difference(
      String expected, @Nullable Object actual, Tolerance tolerance) {
    if (actual != null && actual.getClass().isRecord()) {
      return structDifference(Literals.members(expected), actual, tolerance);
    }
    List<?> elements = actual == null ? null : Literals.elementsOf(actual);
    return elements == null
        ? single(expected, actual, tolerance).map(text -> new Difference("", text))
        : sequenceDifference(Literals.elements(expected), elements, tolerance);
  }

  private static Optional<String> single(
      String expected, @Nullable Object actual, Tolerance tolerance) {
    if (actual == null) {
      return expected.equals("null") ? Optional.empty() : unequal(expected, null);
    }
    if (actual instanceof Float || actual instanceof Double) {
      return realDifference(expected, (Number) actual, tolerance);
    }
    if (actual instanceof Number number) {
      return wholeDifference(expected, number, tolerance);
    }
    boolean same =
        actual instanceof Boolean truth
            ? Literals.truth(expected) == truth
            : Literals.of(actual).equals(expected);
    return same ? Optional.empty() : unequal(expected, actual);
  }

  private static Optional<Difference> structDifference(
      Map<String, String> expected, Object actual, Tolerance tolerance) {
    for (var component : actual.getClass().getRecordComponents()) {
      String literal = expected.remove(component.getName());
      Optional<Difference> difference =
          literal == null
              ? Optional.empty()
              : difference(literal, Parts.read(component, actual), tolerance);
      if (difference.isPresent()) {
        return difference.map(d -> d.within("." + component.getName()));
      }
    }
    if (!expected.isEmpty()) {
      throw new CaseDataException(
          actual.getClass().getSimpleName()
              + " has no member "
              + String.join(", ", expected.keySet()));
    }
    return Optional.empty();
  }

  private static Optional<Difference> sequenceDifference(
      List<String> expected, List<?> actual, Tolerance tolerance) {
    for (int i = 0; i < Math.min(expected.size(), actual.size()); i++) {
      String step = "[" + i + "]";
      Optional<Difference> difference = difference(expected.get(i), actual.get(i), tolerance);
      if (difference.isPresent()) {
        return difference.map(d -> d.within(step));
      }
    }
    return expected.size() == actual.size()
        ? Optional.empty()
        : Optional.of(
            new Difference(
                "", "expected " + expected.size() + " elements, but there are " + actual.size()));
  }

  private static Optional<String> realDifference(
      String literal, Number value, Tolerance tolerance) {
    double written = Literals.real(literal);
    double expected = value instanceof Float ? (float) written : written;
    double actual = value.doubleValue();
    if (Double.isNaN(expected) && Double.isNaN(actual) || expected == actual) {
      return Optional.empty();
    }
    boolean finite = Double.isFinite(expected) && Double.isFinite(actual);
    double apart = Math.abs(actual - expected);
    double unit = value instanceof Float ? Math.ulp((float) expected) : Math.ulp(expected);
    double allowed = tolerance.allowed(expected, unit);
    if (finite && apart <= allowed) {
      return Optional.empty();
    }
    return finite ? outside(literal, value, apart, tolerance, allowed) : unequal(literal, value);
  }

  private static Optional<String> wholeDifference(
      String literal, Number value, Tolerance tolerance) {
    if (!Double.isFinite(Literals.real(literal))) {
      return unequal(literal, value);
    }
    BigDecimal expected = Literals.decimal(literal);
    BigDecimal actual =
        value instanceof BigInteger big ? new BigDecimal(big) : new BigDecimal(value.toString());
    BigDecimal apart = actual.subtract(expected).abs();
    BigDecimal allowed =
        new BigDecimal(tolerance.absolute())
            .add(new BigDecimal(tolerance.relative()).multiply(expected.abs()));
    return apart.compareTo(allowed) <= 0
        ? Optional.empty()
        : outside(literal, value, apart.doubleValue(), tolerance, allowed.doubleValue());
  }

  private static Optional<String> outside(
      String literal, Number actual, double apart, Tolerance tolerance, double allowed) {
    String text = "expected " + literal + ", but was " + actual;
    return Optional.of(
        tolerance.isExact() ? text : text + " (differs by " + apart + ", allowed " + allowed + ")");
  }

  private static Optional<String> unequal(String expected, @Nullable Object actual) {
    return Optional.of(
        actual == null || actual instanceof Number || actual instanceof Boolean
            ? "expected " + expected + ", but was " + Literals.of(actual)
            : "expected '" + expected + "', but was '" + Literals.of(actual) + "'");
  }
}
