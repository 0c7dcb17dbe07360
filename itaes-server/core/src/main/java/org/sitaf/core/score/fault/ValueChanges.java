package org.sitaf.core.score.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.verdict.Literals;

/** The faults of values of a type. */
public final class ValueChanges {
  static final DataType DOUBLE = new DataType.Scalar(ScalarType.DOUBLE);

  private ValueChanges() {}

  /** All faults. */
  static List<ValueChange> of(DataType type) {
    if (type instanceof DataType.Scalar scalar && scalar.type().isFloating()) {
      return RealChanges.all(scalar.type() == ScalarType.FLOAT);
    }
    if (type instanceof DataType.Scalar scalar && scalar.type().isInteger()) {
      return WholeChanges.all(scalar.type());
    }
    if (type instanceof DataType.Struct
        || type instanceof DataType.Sequence
        || type instanceof DataType.FixedArray) {
      return StructuredChanges.of(type);
    }
    return few(type);
  }

  /** A few faults of different kinds. */
  static List<ValueChange> few(DataType type) {
    if (type instanceof DataType.Enumeration enumeration) {
      return ofEnumeration(enumeration);
    }
    if (type instanceof DataType.Scalar scalar) {
      ScalarType kind = scalar.type();
      return switch (kind) {
        case VOID -> List.of();
        case BOOLEAN -> ofBooleans();
        case STRING, CHAR -> ofTexts(kind == ScalarType.STRING);
        case FLOAT, DOUBLE -> RealChanges.few(kind == ScalarType.FLOAT);
        default -> WholeChanges.few(kind);
      };
    }
    return type instanceof DataType.Unknown ? RealChanges.few(false) : List.of();
  }

  /**
   * A value that differs clearly from the right one, for faults that occur only under a condition.
   */
  static String wrong(String literal, DataType type) {
    for (ValueChange change : few(type)) {
      if (change.text().contains("too large") || !(type instanceof DataType.Scalar)) {
        String changed = change.apply(literal);
        if (!changed.equals(literal)) {
          return changed;
        }
      }
    }
    for (ValueChange change : of(type)) {
      String changed = change.apply(literal);
      if (!changed.equals(literal)) {
        return changed;
      }
    }
    return literal;
  }

  /** The value that a variable of the type has before it is set. */
  public static String zero(DataType type) {
    if (type instanceof DataType.Enumeration enumeration && !enumeration.literals().isEmpty()) {
      return enumeration.literals().get(0);
    }
    if (type instanceof DataType.Struct struct) {
      return struct.members().stream()
          .map(m -> m.name() + ": " + inner(m.type()))
          .collect(Collectors.joining(", ", "{", "}"));
    }
    if (type instanceof DataType.FixedArray array) {
      return java.util.Collections.nCopies(array.length(), inner(array.element())).stream()
          .collect(Collectors.joining(", ", "[", "]"));
    }
    if (type instanceof DataType.Sequence) {
      return "[]";
    }
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case VOID -> "null";
        case BOOLEAN -> "false";
        case STRING, CHAR -> "";
        case FLOAT, DOUBLE -> "0.0";
        default -> "0";
      };
    }
    return "0.0";
  }

  private static String inner(DataType type) {
    return type instanceof DataType.Scalar scalar
            && (scalar.type() == ScalarType.STRING || scalar.type() == ScalarType.CHAR)
        ? "\"\""
        : zero(type);
  }

  private static List<ValueChange> ofBooleans() {
    return List.of(
        new ValueChange(
            "inverted",
            literal ->
                Literals.isBoolean(literal)
                    ? Boolean.toString(!Boolean.parseBoolean(literal))
                    : literal),
        new ValueChange("always true", literal -> "true"),
        new ValueChange("always false", literal -> "false"));
  }

  private static List<ValueChange> ofEnumeration(DataType.Enumeration enumeration) {
    List<String> literals = enumeration.literals();
    List<ValueChange> changes = new ArrayList<>();
    if (literals.size() > 1) {
      changes.add(
          new ValueChange(
              "next literal",
              literal -> {
                int index = literals.indexOf(literal);
                return index < 0 ? literal : literals.get((index + 1) % literals.size());
              }));
      changes.add(new ValueChange("always " + literals.get(0), literal -> literals.get(0)));
      String last = literals.get(literals.size() - 1);
      changes.add(new ValueChange("always " + last, literal -> last));
    }
    return changes;
  }

  private static List<ValueChange> ofTexts(boolean several) {
    if (!several) {
      return List.of(new ValueChange("always a blank", literal -> " "));
    }
    return List.of(
        new ValueChange("always empty", literal -> ""),
        new ValueChange("a blank appended", literal -> literal + " "),
        new ValueChange("first character lost", literal -> cut(literal, true)),
        new ValueChange("last character lost", literal -> cut(literal, false)),
        new ValueChange("in upper case", literal -> literal.toUpperCase(Locale.ROOT)),
        new ValueChange("in lower case", literal -> literal.toLowerCase(Locale.ROOT)),
        new ValueChange("reversed", literal -> new StringBuilder(literal).reverse().toString()));
  }

  private static String cut(String literal, boolean first) {
    if (literal.isEmpty()) {
      return literal;
    }
    return first
        ? literal.substring(literal.offsetByCodePoints(0, 1))
        : literal.substring(0, literal.offsetByCodePoints(literal.length(), -1));
  }
}
