package org.sitaf.core.verdict;

import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Tolerance;

/**
 * Compares a recorded literal with the expected one (docs/test-application.md, Comparison). Used
 * for the test applications of all languages. Both literals are untrusted, so the time is limited
 * to a few passes over each.
 *
 * @param type of the output; if unknown, it is derived from the literals
 */
record ValueComparison(DataType type, Tolerance tolerance) {
  /** For an output of unknown type. */
  static final ValueComparison UNTYPED =
      new ValueComparison(new DataType.Unknown(""), Tolerance.EXACT);

  private static final int MAX_DEPTH = 64;

  /** Maximum number of digits of an integer in any number type. */
  private static final int MAX_DIGITS = 400;

  ValueComparison {
    Objects.requireNonNull(type);
    Objects.requireNonNull(tolerance);
  }

  /** Thrown if the expected literal does not fit the type. */
  private static final class IncomparableException extends Exception {
    private static final long serialVersionUID = 1L;
    private final String path;

    IncomparableException(String path, String message) {
      super(message);
      this.path = path;
    }
  }

  /** The first difference; empty if the value is as expected. */
  Optional<Mismatch> mismatch(String expected, String actual) {
    try {
      return Optional.ofNullable(compare("", expected, actual, type, 0));
    } catch (IncomparableException e) {
      return Optional.of(
          new Mismatch(
              Verdict.ERROR, e.path, "the expected value cannot be compared: " + e.getMessage()));
    }
  }

  private @Nullable Mismatch compare(
      String path, String expected, String actual, DataType of, int depth)
      throws IncomparableException {
    if (expected.equals(actual)) {
      return null;
    }
    if (depth > MAX_DEPTH) {
      throw new IncomparableException(path, "it is nested more than " + MAX_DEPTH + " levels deep");
    }
    if (of instanceof DataType.Sequence sequence) {
      return compareElements(path, expected, actual, sequence.element(), depth);
    }
    if (of instanceof DataType.FixedArray array) {
      return compareElements(path, expected, actual, array.element(), depth);
    }
    if (of instanceof DataType.Struct) {
      return compareMembers(path, expected, actual, of, depth);
    }
    if (of instanceof DataType.Scalar scalar) {
      return compareScalars(path, expected, actual, scalar.type());
    }
    if (of instanceof DataType.Enumeration) {
      return expected.strip().equals(actual.strip())
          ? null
          : different(path, expected, actual, true);
    }
    return compareUntyped(path, expected, actual, of, depth);
  }

  private @Nullable Mismatch compareUntyped(
      String path, String expected, String actual, DataType of, int depth)
      throws IncomparableException {
    if (Literals.isSequence(expected) && Literals.isSequence(actual)) {
      return compareElements(path, expected, actual, of, depth);
    }
    if (Literals.isStruct(expected) && Literals.isStruct(actual)) {
      return compareMembers(path, expected, actual, of, depth);
    }
    if (Literals.isBoolean(actual)) {
      return Literals.normalizedBoolean(expected).equals(actual)
          ? null
          : different(path, expected, actual, !Literals.isNumber(expected));
    }
    if (Literals.isReal(expected) && Literals.isReal(actual)) {
      return compareReals(path, expected, actual, false);
    }
    String text = Literals.escaped(expected);
    return text.equals(actual) || text.strip().equals(actual)
        ? null
        : different(path, expected, actual, !isBare(expected) || !isBare(actual));
  }

  private static boolean isBare(String literal) {
    return literal.equals(Literals.NULL)
        || Literals.isBoolean(literal)
        || Literals.isReal(literal)
        || Literals.isSequence(literal)
        || Literals.isStruct(literal);
  }

  private @Nullable Mismatch compareElements(
      String path, String expected, String actual, DataType element, int depth)
      throws IncomparableException {
    List<String> expectedElements;
    try {
      expectedElements = Literals.elements(expected);
    } catch (IllegalArgumentException e) {
      throw new IncomparableException(path, String.valueOf(e.getMessage()));
    }
    List<String> actualElements;
    try {
      actualElements = Literals.elements(actual);
    } catch (IllegalArgumentException e) {
      return different(path, expected, actual, false);
    }
    for (int i = 0; i < Math.min(expectedElements.size(), actualElements.size()); i++) {
      Mismatch found =
          compare(
              path + "[" + i + "]",
              expectedElements.get(i),
              actualElements.get(i),
              element,
              depth + 1);
      if (found != null) {
        return found;
      }
    }
    return expectedElements.size() == actualElements.size()
        ? null
        : new Mismatch(
            Verdict.FAIL,
            path,
            "expected "
                + expectedElements.size()
                + " elements, but there are "
                + actualElements.size());
  }

  private @Nullable Mismatch compareMembers(
      String path, String expected, String actual, DataType type, int depth)
      throws IncomparableException {
    Map<String, String> expectedMembers;
    try {
      expectedMembers = Literals.members(expected);
    } catch (IllegalArgumentException e) {
      throw new IncomparableException(path, String.valueOf(e.getMessage()));
    }
    if (type instanceof DataType.Struct struct) {
      requireMembers(path, struct, expectedMembers);
    }
    Map<String, String> actualMembers;
    try {
      actualMembers = Literals.members(actual);
    } catch (IllegalArgumentException e) {
      return different(path, expected, actual, false);
    }
    for (Map.Entry<String, String> member : expectedMembers.entrySet()) {
      String name = member.getKey();
      String value = actualMembers.get(name);
      Mismatch found =
          value == null
              ? new Mismatch(
                  Verdict.FAIL,
                  path + "." + name,
                  "expected " + Literals.shortened(member.getValue()) + ", but there is none")
              : compare(path + "." + name, member.getValue(), value, type.member(name), depth + 1);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  /** An expected member that the type does not have is an error in the suite, not a wrong value. */
  private static void requireMembers(
      String path, DataType.Struct struct, Map<String, String> expectedMembers)
      throws IncomparableException {
    List<String> known = struct.members().stream().map(DataType.Member::name).toList();
    String unknown =
        expectedMembers.keySet().stream()
            .filter(name -> !known.contains(name))
            .collect(Collectors.joining(", "));
    if (!unknown.isEmpty()) {
      throw new IncomparableException(
          path,
          struct.name()
              + " has no member "
              + Literals.shortened(unknown)
              + "; it has "
              + String.join(", ", known));
    }
  }

  private @Nullable Mismatch compareScalars(
      String path, String expected, String actual, ScalarType scalar) throws IncomparableException {
    if (scalar == ScalarType.VOID) {
      throw new IncomparableException(
          path,
          "the method returns nothing, so only null or an error such as !error:NAME can be"
              + " expected, not "
              + Literals.shortened(expected));
    }
    if (scalar == ScalarType.BOOLEAN || scalar.isNumeric() && Literals.isBoolean(actual)) {
      return compareBooleans(path, expected, actual);
    }
    if (scalar.isInteger()) {
      return compareIntegers(path, expected, actual);
    }
    if (scalar.isFloating()) {
      return compareReals(path, expected, actual, scalar == ScalarType.FLOAT);
    }
    return Literals.escaped(expected).equals(actual)
        ? null
        : different(path, expected, actual, true);
  }

  private static @Nullable Mismatch compareBooleans(String path, String expected, String actual)
      throws IncomparableException {
    String expectedValue = Literals.normalizedBoolean(expected);
    if (!Literals.isBoolean(expectedValue)) {
      throw new IncomparableException(
          path, "'" + Literals.shortened(expected) + "' is neither true nor false");
    }
    return expectedValue.equals(actual) ? null : different(path, expected, actual, false);
  }

  private @Nullable Mismatch compareIntegers(String path, String expected, String actual)
      throws IncomparableException {
    double approximate = number(path, expected);
    if (!Double.isFinite(approximate) && !Literals.isNumber(expected)
        || !Literals.isNumber(actual)) {
      return Literals.isReal(actual) && Double.compare(Literals.real(actual), approximate) == 0
          ? null
          : different(path, expected, actual, false);
    }
    BigDecimal expectedValue;
    try {
      expectedValue = parseDecimal(expected.strip());
    } catch (IllegalArgumentException e) {
      throw new IncomparableException(path, String.valueOf(e.getMessage()));
    }
    BigDecimal actualValue;
    try {
      actualValue = parseDecimal(actual.strip());
    } catch (IllegalArgumentException e) {
      return different(path, expected, actual, false);
    }
    BigDecimal difference = actualValue.subtract(expectedValue).abs();
    BigDecimal allowed =
        new BigDecimal(tolerance.absolute())
            .add(new BigDecimal(tolerance.relative()).multiply(expectedValue.abs()));
    return difference.compareTo(allowed) <= 0
        ? null
        : outsideTolerance(path, expected, actual, difference.doubleValue(), allowed.doubleValue());
  }

  /** Limits the digits: arithmetic with {@code 1e999999999} would use all memory. */
  private static BigDecimal parseDecimal(String literal) {
    // Parsing many digits takes quadratic time.
    BigDecimal number = literal.length() > MAX_DIGITS ? BigDecimal.ZERO : new BigDecimal(literal);
    if ((long) literal.length() + Math.abs((long) number.scale()) > MAX_DIGITS) {
      throw new IllegalArgumentException(
          "'" + Literals.shortened(literal) + "' has more digits than any number type");
    }
    return number;
  }

  private @Nullable Mismatch compareReals(
      String path, String expected, String actual, boolean single) throws IncomparableException {
    double exact = number(path, expected);
    if (!Literals.isReal(actual)) {
      return different(path, expected, actual, false);
    }
    double expectedValue = single ? (float) exact : exact;
    double actualValue = single ? (float) Literals.real(actual) : Literals.real(actual);
    if (Double.isNaN(expectedValue) && Double.isNaN(actualValue) || expectedValue == actualValue) {
      return null;
    }
    if (!Double.isFinite(expectedValue) || !Double.isFinite(actualValue)) {
      return different(path, expected, actual, false);
    }
    double unit = single ? Math.ulp((float) expectedValue) : Math.ulp(expectedValue);
    double allowed =
        tolerance.absolute()
            + tolerance.relative() * Math.abs(expectedValue)
            + tolerance.ulp() * unit;
    double difference = Math.abs(actualValue - expectedValue);
    return difference <= allowed
        ? null
        : outsideTolerance(path, expected, actual, difference, allowed);
  }

  private static double number(String path, String expected) throws IncomparableException {
    if (!Literals.isReal(expected)) {
      throw new IncomparableException(
          path, "'" + Literals.shortened(expected) + "' is not a number");
    }
    return Literals.real(expected);
  }

  private Mismatch outsideTolerance(
      String path, String expected, String actual, double difference, double allowed) {
    Mismatch bare = different(path, expected, actual, false);
    return tolerance.equals(Tolerance.EXACT)
        ? bare
        : new Mismatch(
            Verdict.FAIL,
            path,
            bare.text() + " (differs by " + difference + ", allowed " + allowed + ")");
  }

  private static Mismatch different(String path, String expected, String actual, boolean quoted) {
    String quote = quoted ? "'" : "";
    return new Mismatch(
        Verdict.FAIL,
        path,
        "expected "
            + quote
            + Literals.shortened(expected)
            + quote
            + ", but was "
            + quote
            + Literals.shortened(actual)
            + quote);
  }
}
