package org.sitaf.core.value.spatial;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;

/** Writes numbers as a literal of a type: as members of a struct, or as cells of a sequence. */
final class NumberLiterals {
  private NumberLiterals() {}

  /** Cells of a sequence; nine cells of a sequence of sequences are three rows. */
  static String cells(List<Double> cells, DataType as) {
    DataType element = element(as);
    if (isList(element)) {
      if (cells.size() != 9) {
        throw new IllegalArgumentException(
            name(as) + " has rows, but only as=\"matrix\" is written by rows");
      }
      requireLength(as, 3);
      return List.of(cells.subList(0, 3), cells.subList(3, 6), cells.subList(6, 9)).stream()
          .map(row -> cells(row, element))
          .collect(Collectors.joining(", ", "[", "]"));
    }
    requireLength(as, cells.size());
    return cells.stream()
        .map(cell -> number(cell, element))
        .collect(Collectors.joining(", ", "[", "]"));
  }

  private static void requireLength(DataType as, int length) {
    int bound =
        as instanceof DataType.FixedArray array
            ? array.length()
            : as instanceof DataType.Sequence sequence && sequence.bound() > 0
                ? sequence.bound()
                : length;
    if (bound < length || (as instanceof DataType.FixedArray && bound != length)) {
      throw new IllegalArgumentException(
          name(as) + " cannot hold " + length + " cells; check the attribute as");
    }
  }

  static String members(DataType as, List<String> names, List<Double> numbers) {
    if (!(as instanceof DataType.Struct) && !(as instanceof DataType.Unknown)) {
      throw new IllegalArgumentException(
          name(as) + " cannot hold the members " + String.join(", ", names));
    }
    requireMembers(names, as);
    Map<String, String> literals = new HashMap<>();
    for (int i = 0; i < names.size(); i++) {
      literals.put(names.get(i), number(numbers.get(i), as.member(names.get(i))));
    }
    return struct(as, names, literals);
  }

  static void requireMembers(List<String> names, DataType as) {
    if (as instanceof DataType.Struct struct) {
      List<String> members = struct.members().stream().map(DataType.Member::name).toList();
      if (!members.containsAll(names)) {
        throw new IllegalArgumentException(
            struct.name()
                + " needs the members "
                + String.join(", ", names)
                + ", but it has "
                + String.join(", ", members));
      }
    }
  }

  /** The members in the order of the struct; those without a literal have their default. */
  static String struct(DataType as, List<String> names, Map<String, String> literals) {
    return as instanceof DataType.Struct struct
        ? struct.members().stream()
            .map(
                m ->
                    m.name()
                        + ": "
                        + (literals.containsKey(m.name())
                            ? literals.get(m.name())
                            : defaultOf(m.type())))
            .collect(Collectors.joining(", ", "{", "}"))
        : names.stream()
            .map(name -> name + ": " + literals.get(name))
            .collect(Collectors.joining(", ", "{", "}"));
  }

  private static String defaultOf(DataType type) {
    if (type instanceof DataType.Struct) {
      return struct(type, List.of(), Map.of());
    }
    if (type instanceof DataType.FixedArray array) {
      return String.join(
              ", ", java.util.Collections.nCopies(array.length(), defaultOf(array.element())))
          .transform(cells -> "[" + cells + "]");
    }
    if (type instanceof DataType.Sequence) {
      return "[]";
    }
    if (type instanceof DataType.Enumeration enumeration && !enumeration.literals().isEmpty()) {
      return enumeration.literals().get(0);
    }
    if (type instanceof DataType.Scalar scalar) {
      return switch (scalar.type()) {
        case STRING, CHAR -> "\"\"";
        case BOOLEAN -> "false";
        case FLOAT, DOUBLE -> "0.0";
        default -> "0";
      };
    }
    return "\"\"";
  }

  private static String number(double number, DataType type) {
    if (type instanceof DataType.Scalar scalar) {
      if (scalar.type() == ScalarType.FLOAT) {
        return Float.toString((float) number);
      }
      if (scalar.type() != ScalarType.DOUBLE) {
        throw new IllegalArgumentException(
            "needs floating-point numbers, not " + scalar.typeName());
      }
    }
    return Double.toString(number);
  }

  static boolean isList(DataType type) {
    return type instanceof DataType.Sequence || type instanceof DataType.FixedArray;
  }

  private static DataType element(DataType type) {
    return type.parts().isEmpty() ? new DataType.Unknown("") : type.parts().get(0);
  }

  static String name(DataType type) {
    return type.typeName().isEmpty() ? "the type" : type.typeName();
  }
}
