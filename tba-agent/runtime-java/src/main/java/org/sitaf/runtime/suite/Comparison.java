package org.sitaf.runtime.suite;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.List;
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
 *   <li>Sequences compare element by element; strings, characters and booleans have no tolerance.
 * </ul>
 */
final class Comparison {
  private Comparison() {}

  /** The first difference in words; empty when the actual value is as expected. */
  static Optional<String> difference(
      String expected, @Nullable Object actual, Tolerance tolerance) {
    if (actual == null) {
      return expected.equals("null") ? Optional.empty() : unequal(expected, null);
    }
    List<?> elements = Literals.elementsOf(actual);
    if (elements != null) {
      return sequenceDifference(Literals.elements(expected), elements, tolerance);
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

  private static Optional<String> sequenceDifference(
      List<String> expected, List<?> actual, Tolerance tolerance) {
    for (int i = 0; i < Math.min(expected.size(), actual.size()); i++) {
      Optional<String> difference = difference(expected.get(i), actual.get(i), tolerance);
      if (difference.isPresent()) {
        return Optional.of("element " + i + ": " + difference.get());
      }
    }
    return expected.size() == actual.size()
        ? Optional.empty()
        : Optional.of("expected " + expected.size() + " elements, but there are " + actual.size());
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
    if (finite && apart <= tolerance.allowed(expected)) {
      return Optional.empty();
    }
    return finite ? outside(literal, value, apart, tolerance, expected) : unequal(literal, value);
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
        : outside(literal, value, apart.doubleValue(), tolerance, expected.doubleValue());
  }

  private static Optional<String> outside(
      String literal, Number actual, double apart, Tolerance tolerance, double expected) {
    String text = "expected " + literal + ", but was " + actual;
    return Optional.of(
        tolerance.isExact()
            ? text
            : text + " (differs by " + apart + ", allowed " + tolerance.allowed(expected) + ")");
  }

  private static Optional<String> unequal(String expected, @Nullable Object actual) {
    return Optional.of(
        actual == null || actual instanceof Number || actual instanceof Boolean
            ? "expected " + expected + ", but was " + Literals.of(actual)
            : "expected '" + expected + "', but was '" + Literals.of(actual) + "'");
  }
}
