package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/** Parses literals of values (docs/test-application.md, Values). */
public final class Literals {
  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d{1,9})?");

  /** A missing value; also the recorded value of a method that returns nothing. */
  static final String NULL = "null";

  /** Longest literal of a number, in characters. */
  private static final int MAX_NUMBER = 2000;

  private static final int MAX_SHOWN = 200;

  private Literals() {}

  public static boolean isSequence(String literal) {
    return isBetween(literal, '[', ']');
  }

  public static boolean isStruct(String literal) {
    return isBetween(literal, '{', '}');
  }

  private static boolean isBetween(String literal, char open, char close) {
    String text = literal.strip();
    return text.length() >= 2 && text.charAt(0) == open && text.charAt(text.length() - 1) == close;
  }

  public static boolean isBoolean(String literal) {
    return literal.equals("true") || literal.equals("false");
  }

  /** {@code true} for 1 and {@code false} for 0; any other text unchanged. */
  static String normalizedBoolean(String literal) {
    return switch (literal.strip()) {
      case "true", "1" -> "true";
      case "false", "0" -> "false";
      default -> literal;
    };
  }

  /** A finite number in decimal. */
  public static boolean isNumber(String literal) {
    String text = literal.strip();
    return text.length() <= MAX_NUMBER && NUMBER.matcher(text).matches();
  }

  /** A number in decimal, an infinity or NaN. */
  public static boolean isReal(String literal) {
    String text = literal.strip();
    return text.length() <= MAX_NUMBER
        && (NUMBER.matcher(text).matches() || !Double.isNaN(special(text)) || isNan(text));
  }

  /** The number of a literal for which {@link #isReal} holds. */
  public static double real(String literal) {
    String text = literal.strip();
    return NUMBER.matcher(text).matches() ? Double.parseDouble(text) : special(text);
  }

  private static boolean isNan(String text) {
    String lower = text.toLowerCase(Locale.ROOT);
    return lower.equals("nan") || lower.equals(".nan");
  }

  private static double special(String text) {
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "infinity", "+infinity", "inf", "+inf", ".inf" -> Double.POSITIVE_INFINITY;
      case "-infinity", "-inf", "-.inf" -> Double.NEGATIVE_INFINITY;
      default -> Double.NaN;
    };
  }

  /** The elements of {@code [a, b]}, strings without their quotes. */
  public static List<String> elements(String literal) {
    List<String> elements = new ArrayList<>();
    parts(literal, '[', ']', "a sequence such as [1, 2]")
        .forEach(part -> elements.add(unquoted(part)));
    return elements;
  }

  /** The members of <code>{x: 1.0, y: 2.0}</code> in their order, strings without their quotes. */
  public static Map<String, String> members(String literal) {
    Map<String, String> members = writtenMembers(literal);
    members.replaceAll((name, value) -> unquoted(value));
    return members;
  }

  /** The elements of {@code [a, b]} as they are written. */
  public static List<String> writtenElements(String literal) {
    return parts(literal, '[', ']', "a sequence such as [1, 2]");
  }

  /** The members of <code>{x: 1.0, y: 2.0}</code> in their order, as they are written. */
  public static Map<String, String> writtenMembers(String literal) {
    Map<String, String> members = new LinkedHashMap<>();
    for (String part : parts(literal, '{', '}', "a struct such as {x: 1.0, y: 2.0}")) {
      int colon = part.indexOf(':');
      if (colon < 0) {
        throw new IllegalArgumentException(
            "'" + shortened(literal) + "' has a member without a name");
      }
      members.put(part.substring(0, colon).strip(), part.substring(colon + 1).strip());
    }
    return members;
  }

  /** Splits at the commas that are not within quotes, brackets or braces. */
  private static List<String> parts(String literal, char open, char close, String example) {
    String text = literal.strip();
    if (!isBetween(text, open, close)) {
      throw new IllegalArgumentException("'" + shortened(literal) + "' is not " + example);
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
      } else if (c == '"') {
        quoted = true;
      } else if (c == '[' || c == '{') {
        depth++;
      } else if (c == ']' || c == '}') {
        depth--;
      } else if (c == ',' && depth == 0) {
        parts.add(text.substring(from, i).strip());
        from = i + 1;
      }
    }
    if (quoted) {
      throw new IllegalArgumentException(
          "'" + shortened(literal) + "' has a quote that is not closed");
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

  /** The literal, shortened for messages. */
  static String shortened(String literal) {
    return literal.length() <= MAX_SHOWN
        ? literal
        : literal.substring(0, MAX_SHOWN) + " ... (" + literal.length() + " characters)";
  }

  /**
   * Replaces the characters that XML does not allow by escapes such as <code>&#92;u0000</code>, as
   * in records.
   */
  static String escaped(String text) {
    StringBuilder escaped = new StringBuilder();
    text.codePoints()
        .forEach(
            c -> {
              if (isXml(c)) {
                escaped.appendCodePoint(c);
              } else {
                escaped.append(String.format(Locale.ROOT, "\\u%04X", c));
              }
            });
    return escaped.toString();
  }

  /** Production Char of XML 1.0. */
  private static boolean isXml(int c) {
    return c == '\t'
        || c == '\n'
        || c == '\r'
        || c >= 0x20 && c <= 0xD7FF
        || c >= 0xE000 && c <= 0xFFFD
        || c >= 0x10000;
  }
}
