package org.sitaf.core.beginning;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.description.DataType;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Values of types, as test models and results write them. */
final class Literals {
  private static final int SHORT = 3;
  private static final int MAX_LENGTH = 100_000;

  private Literals() {}

  /** The value whose parts are all zero or empty. */
  static String zero(DataType type) {
    return type instanceof DataType.Scalar || type instanceof DataType.Enumeration
        ? scalar(type, 0)
        : inner(type, 0);
  }

  /** Values of a sequence: empty, of one element, of several; of an array: two contents. */
  static List<String> lists(DataType type) {
    if (type instanceof DataType.FixedArray) {
      return List.of(inner(type, 0), inner(type, 1)).stream().distinct().toList();
    }
    if (!(type instanceof DataType.Sequence sequence)) {
      return List.of(zero(type));
    }
    List<String> values = new ArrayList<>(List.of("[]"));
    int most = sequence.bound() == 0 ? SHORT : Math.min(SHORT, sequence.bound());
    for (int length : new int[] {1, most}) {
      List<String> elements = new ArrayList<>();
      for (int i = 0; i < length; i++) {
        elements.add(inner(sequence.element(), i));
      }
      values.add("[" + String.join(", ", elements) + "]");
    }
    return values.stream().distinct().toList();
  }

  private static String inner(DataType type, int seed) {
    StringBuilder text = new StringBuilder();
    append(type, seed, text);
    return text.toString();
  }

  /** A few nested types or one long array can have values that fill the memory. */
  private static void append(DataType type, int seed, StringBuilder text) {
    if (text.length() > MAX_LENGTH) {
      throw InvalidInputException.of(
          "interface",
          "a type has no value of less than %d characters; leave out the methods that use it, or"
                  .formatted(MAX_LENGTH)
              + " shorten its arrays");
    }
    if (type instanceof DataType.Sequence) {
      text.append("[]");
    } else if (type instanceof DataType.FixedArray array) {
      text.append('[');
      for (int i = 0; i < array.length(); i++) {
        text.append(i == 0 ? "" : ", ");
        append(array.element(), seed, text);
      }
      text.append(']');
    } else if (type instanceof DataType.Struct struct) {
      text.append('{');
      String separator = "";
      for (DataType.Member member : struct.members()) {
        text.append(separator).append(member.name()).append(": ");
        append(member.type(), seed, text);
        separator = ", ";
      }
      text.append('}');
    } else {
      text.append(quoted(type, seed));
    }
  }

  private static String quoted(DataType type, int seed) {
    boolean text =
        type instanceof DataType.Enumeration
            || (type instanceof DataType.Scalar scalar
                && (scalar.type() == org.sitaf.core.description.ScalarType.STRING
                    || scalar.type() == org.sitaf.core.description.ScalarType.CHAR));
    return text ? "\"" + scalar(type, seed) + "\"" : scalar(type, seed);
  }

  private static String scalar(DataType type, int seed) {
    if (type instanceof DataType.Enumeration enumeration) {
      return enumeration.literals().get(seed % enumeration.literals().size());
    }
    if (!(type instanceof DataType.Scalar scalar)) {
      return "";
    }
    return switch (scalar.type()) {
      case VOID -> "";
      case BOOLEAN -> seed % 2 == 0 ? "false" : "true";
      case CHAR -> String.valueOf((char) ('a' + seed));
      case STRING -> seed == 0 ? "" : "a".repeat(seed);
      case FLOAT, DOUBLE -> seed + ".0";
      default -> String.valueOf(seed);
    };
  }
}
