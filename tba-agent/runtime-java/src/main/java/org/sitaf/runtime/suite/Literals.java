package org.sitaf.runtime.suite;

import java.lang.reflect.Array;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.StringJoiner;
import org.jspecify.annotations.Nullable;

/**
 * Values as documents spell them: numbers in decimal, {@code NaN}, {@code Infinity} and {@code
 * -Infinity}, {@code true} and {@code false}, strings as they are, and sequences as {@code [1.0,
 * 2.5]} with strings inside them in double quotes.
 */
final class Literals {
  private Literals() {}

  /** A floating-point number. */
  static double real(String literal) {
    String text = literal.strip();
    switch (text.toLowerCase(Locale.ROOT)) {
      case "nan", ".nan":
        return Double.NaN;
      case "infinity", "+infinity", "inf", "+inf", ".inf":
        return Double.POSITIVE_INFINITY;
      case "-infinity", "-inf", "-.inf":
        return Double.NEGATIVE_INFINITY;
      default:
        double number = decimal(literal).doubleValue();
        return number == 0 && text.startsWith("-") ? -0.0 : number;
    }
  }

  /** A finite number, exactly as written. */
  static BigDecimal decimal(String literal) {
    try {
      return new BigDecimal(literal.strip());
    } catch (NumberFormatException e) {
      throw new CaseDataException("'" + literal + "' is not a number", e);
    }
  }

  /** A whole number within bounds, both inclusive. */
  static long whole(String literal, long min, long max) {
    long number;
    try {
      number = decimal(literal).longValueExact();
    } catch (ArithmeticException e) {
      throw new CaseDataException("'" + literal + "' is not a whole number of 64 bits", e);
    }
    if (number < min || number > max) {
      throw new CaseDataException(literal + " is outside of " + min + " to " + max);
    }
    return number;
  }

  static boolean truth(String literal) {
    return switch (literal.strip()) {
      case "true", "1" -> true;
      case "false", "0" -> false;
      default -> throw new CaseDataException("'" + literal + "' is neither true nor false");
    };
  }

  static char character(String literal) {
    if (literal.length() != 1) {
      throw new CaseDataException("'" + literal + "' is not one character");
    }
    return literal.charAt(0);
  }

  /**
   * The elements of {@code [a, b]}; a quoted element may hold commas, brackets and escaped quotes.
   */
  static List<String> elements(String literal) {
    String text = literal.strip();
    if (text.length() < 2 || text.charAt(0) != '[' || text.charAt(text.length() - 1) != ']') {
      throw new CaseDataException("'" + literal + "' is not a sequence such as [1, 2]");
    }
    List<String> elements = new ArrayList<>();
    StringBuilder element = new StringBuilder();
    boolean quoted = false;
    boolean wasQuoted = false;
    for (int i = 1; i < text.length() - 1; i++) {
      char c = text.charAt(i);
      if (quoted && c == '\\' && i + 1 < text.length() - 1) {
        element.append(text.charAt(++i));
      } else if (c == '"') {
        quoted = !quoted;
        wasQuoted = true;
      } else if (c == ',' && !quoted) {
        elements.add(wasQuoted ? element.toString() : element.toString().strip());
        element.setLength(0);
        wasQuoted = false;
      } else if (quoted || !wasQuoted || !Character.isWhitespace(c)) {
        if (!quoted && element.isEmpty() && Character.isWhitespace(c)) {
          continue;
        }
        element.append(c);
      }
    }
    if (quoted) {
      throw new CaseDataException("'" + literal + "' has a quote that does not end");
    }
    if (!elements.isEmpty() || wasQuoted || !element.toString().isBlank()) {
      elements.add(wasQuoted ? element.toString() : element.toString().strip());
    }
    return elements;
  }

  /** The spelling of a value that a component gave. */
  static String of(@Nullable Object value) {
    if (value == null) {
      return "null";
    }
    if (value instanceof Enum<?> constant) {
      return constant.name();
    }
    List<?> elements = elementsOf(value);
    if (elements == null) {
      return value.toString();
    }
    StringJoiner text = new StringJoiner(", ", "[", "]");
    for (Object element : elements) {
      text.add(
          element instanceof CharSequence || element instanceof Character
              ? quote(element)
              : of(element));
    }
    return text.toString();
  }

  /** The elements of an array or a collection; null for anything else. */
  static @Nullable List<?> elementsOf(Object value) {
    if (value.getClass().isArray()) {
      List<@Nullable Object> elements = new ArrayList<>();
      for (int i = 0; i < Array.getLength(value); i++) {
        elements.add(Array.get(value, i));
      }
      return elements;
    }
    return value instanceof Iterable<?> iterable ? listOf(iterable) : null;
  }

  private static List<?> listOf(Iterable<?> iterable) {
    List<@Nullable Object> elements = new ArrayList<>();
    iterable.forEach(elements::add);
    return elements;
  }

  private static String quote(Object text) {
    return '"' + text.toString().replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}
