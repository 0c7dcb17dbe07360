package org.sitaf.runtime.suite;

import java.lang.reflect.Array;
import java.lang.reflect.RecordComponent;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes literals (docs/test-application.md, Literals): numbers in decimal, {@code NaN},
 * {@code Infinity} and {@code -Infinity}, {@code true} and {@code false}, strings without quotes,
 * sequences as {@code [1.0, 2.5]} and structs as <code>{x: 1.0}</code>, with nested strings in
 * double quotes.
 */
final class Literals {
  /** A number of 15 digits is below 2^53, so a double holds it exactly. */
  private static final int PLAIN_LENGTH = 15;

  /** All of these are exact. */
  private static final double[] POWERS_OF_TEN = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15
  };

  /** No integer type holds a number of more digits. */
  private static final int MAX_DIGITS = 20;

  /** With this many digits every double and float is read back as the same number. */
  private static final int DIGITS_OF_DOUBLE = 17;

  private static final int DIGITS_OF_FLOAT = 9;

  private Literals() {}

  /** A floating-point number. */
  static double real(String literal) {
    if (isPlain(literal, true)) {
      return plain(literal);
    }
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
  private static BigDecimal decimal(String literal) {
    String text = literal.strip();
    try {
      if (text.chars().allMatch(c -> c < 0x80)) {
        return new BigDecimal(text);
      }
    } catch (NumberFormatException e) {
      throw new CaseDataException("'" + literal + "' is not a number", e);
    }
    throw new CaseDataException("'" + literal + "' is not a number");
  }

  /** An integer within bounds, both inclusive. */
  static long whole(String literal, long min, long max) {
    if (isPlain(literal, false)) {
      long number = Long.parseLong(literal);
      if (number >= min && number <= max) {
        return number;
      }
    } else {
      BigDecimal number = wholeDecimal(literal);
      if (number.compareTo(BigDecimal.valueOf(min)) >= 0
          && number.compareTo(BigDecimal.valueOf(max)) <= 0) {
        return number.longValueExact();
      }
    }
    throw new CaseDataException(literal + " is outside of " + min + " to " + max);
  }

  /** An integer as a BigDecimal: expanding {@code 1e999999999} would exhaust memory. */
  private static BigDecimal wholeDecimal(String literal) {
    BigDecimal number = decimal(literal);
    if (number.stripTrailingZeros().scale() > 0) {
      throw new CaseDataException("'" + literal + "' is not a whole number");
    }
    return number;
  }

  /** Whether a number has few digits and no exponent, so that it can be read without rounding. */
  private static boolean isPlain(String literal, boolean point) {
    int length = literal.length();
    if (length > PLAIN_LENGTH) {
      return false;
    }
    int digits = 0;
    boolean seen = !point;
    for (int i = 0; i < length; i++) {
      char c = literal.charAt(i);
      if (c >= '0' && c <= '9') {
        digits++;
      } else if (c == '.' && !seen && digits > 0) {
        seen = true;
      } else if (c != '-' || i > 0) {
        return false;
      }
    }
    return digits > 0 && literal.charAt(length - 1) != '.';
  }

  /** Both numbers are exact, so their quotient is the nearest number to the literal. */
  private static double plain(String literal) {
    long digits = 0;
    int decimals = -1;
    for (int i = 0; i < literal.length(); i++) {
      char c = literal.charAt(i);
      if (c >= '0' && c <= '9') {
        digits = 10 * digits + (c - '0');
        decimals += decimals < 0 ? 0 : 1;
      } else if (c == '.') {
        decimals = 0;
      }
    }
    double number = decimals <= 0 ? digits : digits / POWERS_OF_TEN[decimals];
    return literal.charAt(0) == '-' ? -number : number;
  }

  static boolean parseBoolean(String literal) {
    return switch (literal.strip()) {
      case "true", "1" -> true;
      case "false", "0" -> false;
      default -> throw new CaseDataException("'" + literal + "' is neither true nor false");
    };
  }

  static char parseCharacter(String literal) {
    if (literal.length() != 1) {
      throw new CaseDataException("'" + literal + "' is not one character");
    }
    return literal.charAt(0);
  }

  /** An unsigned integer of 64 bits, or any smaller one. */
  static BigInteger big(String literal) {
    BigDecimal number = wholeDecimal(literal);
    if (number.precision() - number.scale() > MAX_DIGITS) {
      throw new CaseDataException("'" + literal + "' has more digits than any number type");
    }
    return number.toBigIntegerExact();
  }

  /** The elements of {@code [a, b]}, strings without their quotes. */
  static List<String> elements(String literal) {
    return parts(literal, '[', ']', "a sequence such as [1, 2]").stream()
        .map(Literals::unquoted)
        .toList();
  }

  /** The members of <code>{x: 1.0, y: 2.0}</code> in their order, strings without their quotes. */
  static Map<String, String> members(String literal) {
    String example = "a struct such as {x: 1.0, y: 2.0}";
    Map<String, String> members = new LinkedHashMap<>();
    for (String part : parts(literal, '{', '}', example)) {
      int colon = part.indexOf(':');
      if (colon < 0) {
        throw new CaseDataException("'" + literal + "' has a member without a name");
      }
      members.put(part.substring(0, colon).strip(), unquoted(part.substring(colon + 1).strip()));
    }
    return members;
  }

  /** Splits at the commas that are not within quotes, brackets or braces. */
  private static List<String> parts(String literal, char open, char close, String example) {
    String text = literal.strip();
    if (text.length() < 2 || text.charAt(0) != open || text.charAt(text.length() - 1) != close) {
      throw new CaseDataException("'" + literal + "' is not " + example);
    }
    List<String> parts = new ArrayList<>();
    int from = 1;
    int depth = 0;
    boolean quoted = false;
    for (int i = 1; i < text.length() - 1; i++) {
      char c = text.charAt(i);
      if (quoted) {
        i += c == '\\' ? 1 : 0;
        quoted = c != '"';
      } else {
        switch (c) {
          case '"' -> quoted = true;
          case '[', '{' -> depth++;
          case ']', '}' -> depth--;
          case ',' -> {
            if (depth == 0) {
              parts.add(text.substring(from, i).strip());
              from = i + 1;
            }
          }
          default -> {}
        }
      }
    }
    if (quoted) {
      throw new CaseDataException("'" + literal + "' has a quote that is not closed");
    }
    String last = text.substring(from, text.length() - 1).strip();
    if (!parts.isEmpty() || !last.isEmpty()) {
      parts.add(last);
    }
    return parts;
  }

  private static String unquoted(String part) {
    if (part.length() < 2 || part.charAt(0) != '"' || !part.endsWith("\"")) {
      return part;
    }
    StringBuilder text = new StringBuilder();
    for (int i = 1; i < part.length() - 1; i++) {
      if (part.charAt(i) == '\\' && i + 1 < part.length() - 1) {
        i++;
      }
      text.append(part.charAt(i));
    }
    return text.toString();
  }

  /** The literal of a value. */
  static String of(@Nullable Object value) {
    if (value == null) {
      return "null";
    }
    if (value instanceof Double number) {
      return shortest(
          number.toString(), DIGITS_OF_DOUBLE, text -> Double.parseDouble(text) == number);
    }
    if (value instanceof Float number) {
      return shortest(number.toString(), DIGITS_OF_FLOAT, text -> Float.parseFloat(text) == number);
    }
    if (value instanceof Enum<?> constant) {
      return DocumentNames.of(constant);
    }
    if (value.getClass().isRecord()) {
      StringJoiner text = new StringJoiner(", ", "{", "}");
      for (RecordComponent component : value.getClass().getRecordComponents()) {
        text.add(DocumentNames.of(component) + ": " + nested(Parts.read(component, value)));
      }
      return text.toString();
    }
    List<?> elements = elementsOf(value);
    if (elements == null) {
      return value.toString();
    }
    StringJoiner text = new StringJoiner(", ", "[", "]");
    elements.forEach(element -> text.add(nested(element)));
    return text.toString();
  }

  /**
   * Some releases of Java write one digit too many (JDK-4511638); this removes it when the shorter
   * text is read back as the same number.
   */
  private static String shortest(String text, int digits, Predicate<String> isSame) {
    if (text.length() < digits || !Character.isDigit(text.charAt(text.length() - 1))) {
      return text;
    }
    int mark = text.indexOf('E');
    String number = mark < 0 ? text : text.substring(0, mark);
    String exponent = mark < 0 ? "" : text.substring(mark);
    BigDecimal exact = new BigDecimal(number);
    BigDecimal rounded = exact.round(new MathContext(exact.precision() - 1)).stripTrailingZeros();
    String shorter = rounded.setScale(Math.max(1, rounded.scale())).toPlainString() + exponent;
    return exact.precision() >= digits - 1 && isSame.test(shorter) ? shorter : text;
  }

  private static String nested(@Nullable Object value) {
    return value instanceof CharSequence || value instanceof Character ? quote(value) : of(value);
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
