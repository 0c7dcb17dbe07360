package org.sitaf.core.harness.java.plan;

import java.util.List;
import java.util.Locale;

/**
 * Escapes values and texts of users in Java sources. Java treats {@code &#92;u000a} as a line break
 * everywhere, even in a comment, so every backslash must be escaped.
 */
public final class JavaText {
  private static final int MAX_COMMENT_LENGTH = 600;

  private JavaText() {}

  /** A string literal. */
  public static String string(String text) {
    StringBuilder literal = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      literal.append(escaped(text.charAt(i), '"'));
    }
    return literal.append('"').toString();
  }

  /** A character literal. */
  static String character(char c) {
    return "'" + escaped(c, '\'') + "'";
  }

  /** A double literal, or a constant such as {@code Double.NaN}. */
  static String real(double number) {
    if (Double.isNaN(number)) {
      return "Double.NaN";
    }
    if (Double.isInfinite(number)) {
      return number > 0 ? "Double.POSITIVE_INFINITY" : "Double.NEGATIVE_INFINITY";
    }
    return Double.toString(number);
  }

  private static String escaped(char c, char quote) {
    if (c == quote || c == '\\') {
      return "\\" + c;
    }
    return switch (c) {
      case '\n' -> "\\n";
      case '\r' -> "\\r";
      case '\t' -> "\\t";
      default -> {
        if (c < 0x20 || c == 0x7f) {
          // Octal with three digits: the compiler would replace a Unicode escape by the control
          // character.
          yield String.format(Locale.ROOT, "\\%03o", (int) c);
        }
        yield c < 0x7f || Character.isLetterOrDigit(c)
            ? String.valueOf(c)
            : String.format(Locale.ROOT, "\\u%04x", (int) c);
      }
    };
  }

  /**
   * Escapes a user's text for a documentation comment: a single line without special characters of
   * javac and Javadoc.
   */
  public static String comment(String text) {
    String oneLine =
        text.replaceAll("[\\s\\p{Cntrl}\\p{Cf}\\p{Cs}\\p{Co}\\p{Cn}\\p{Zl}\\p{Zp}]+", " ").strip();
    if (oneLine.length() > MAX_COMMENT_LENGTH) {
      oneLine =
          oneLine.substring(0, oneLine.offsetByCodePoints(0, MAX_COMMENT_LENGTH / 2)) + " ...";
    }
    // Asterisks are escaped, so a slash cannot end the comment.
    StringBuilder encoded = new StringBuilder();
    oneLine
        .codePoints()
        .forEach(
            c -> {
              switch (c) {
                case '\\', '*', '@', '{', '}', '<', '>', '&' ->
                    encoded.append("&#").append(c).append(';');
                default -> encoded.appendCodePoint(c);
              }
            });
    return encoded.toString();
  }

  /**
   * A call as a statement.
   *
   * @param left text before the call: empty, {@code return} or an assignment ending with {@code =}
   */
  public static String call(String left, String callee, List<String> arguments) {
    return (left.isEmpty() ? "" : left + " ") + callee + "(" + String.join(", ", arguments) + ");";
  }

  /**
   * A declaration with parameters.
   *
   * @param end text after the closing bracket
   */
  public static String declaration(String head, List<String> parameters, String end) {
    return head + "(" + String.join(", ", parameters) + ")" + end;
  }
}
