package org.sitaf.core.harness.cpp.syntax;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Locale;

/** Escapes values and texts of users in C++ sources. */
public final class CppText {
  private static final int MAX_COMMENT_LENGTH = 600;

  private CppText() {}

  /** A string literal in UTF-8. */
  public static String string(String text) {
    StringBuilder literal = new StringBuilder("\"");
    text.codePoints().forEach(c -> literal.append(escaped(c, '"')));
    String quoted = literal.append('"').toString();
    // Without a length, the string would end at the first zero byte.
    return text.indexOf('\0') >= 0
        ? "std::string(" + quoted + ", " + text.getBytes(StandardCharsets.UTF_8).length + ")"
        : quoted;
  }

  /** A character literal of one byte. */
  static String character(char c) {
    if (c >= 0x80) {
      throw new IllegalArgumentException("'" + c + "' is not a character of one byte");
    }
    return "'" + escaped(c, '\'') + "'";
  }

  /** A double as an expression. */
  public static String real(double number) {
    if (Double.isNaN(number)) {
      return "std::numeric_limits<double>::quiet_NaN()";
    }
    if (Double.isInfinite(number)) {
      return (number > 0 ? "" : "-") + "std::numeric_limits<double>::infinity()";
    }
    return Double.toString(number).replace("E-", "e-").replace('E', 'e');
  }

  /** A duration as an expression. */
  public static String duration(Duration time) {
    return time.toNanos() % 1_000_000 == 0
        ? "std::chrono::milliseconds(" + time.toMillis() + ")"
        : "std::chrono::nanoseconds(" + time.toNanos() + ")";
  }

  private static String escaped(int c, char quote) {
    if (c == quote || c == '\\') {
      return "\\" + (char) c;
    }
    return switch (c) {
      case '\n' -> "\\n";
      case '\r' -> "\\r";
      case '\t' -> "\\t";
      default -> {
        boolean plain = c >= 0x20 && c < 0x7f && c != '?';
        if (plain || (c >= 0x80 && Character.isLetterOrDigit(c))) {
          yield Character.toString(c);
        }
        StringBuilder bytes = new StringBuilder();
        for (byte b : Character.toString(c).getBytes(StandardCharsets.UTF_8)) {
          // Three digits, so a following digit is not part of the escape.
          bytes.append(String.format(Locale.ROOT, "\\%03o", b & 0xff));
        }
        yield bytes.toString();
      }
    };
  }

  /**
   * Escapes a user's text for a comment: a single line without special characters. A backslash at
   * the end of a line would continue the comment on the next line.
   */
  public static String comment(String text) {
    String oneLine =
        text.replaceAll("[\\s\\p{Cntrl}\\p{Cf}\\p{Cs}\\p{Co}\\p{Cn}\\p{Zl}\\p{Zp}]+", " ").strip();
    if (oneLine.length() > MAX_COMMENT_LENGTH) {
      oneLine =
          oneLine.substring(0, oneLine.offsetByCodePoints(0, MAX_COMMENT_LENGTH / 2)) + " ...";
    }
    return oneLine
        .replace("\\", "(backslash)")
        .replace("*/", "* /")
        .replace("/*", "/ *")
        .replace("??/", "?? /");
  }

  /**
   * A call or a declaration with a list in brackets.
   *
   * @param head text up to and including the opening bracket
   * @param tail text from the closing bracket on
   */
  public static String list(String head, List<String> parts, String tail) {
    return head + String.join(", ", parts) + tail;
  }

  /** A constructor that only initializes members. */
  public static String constructor(String head, List<String> initialisers) {
    return list(head + " : ", initialisers, " {}");
  }

  /** An assignment or a declaration with a value. */
  public static String assignment(String left, String right) {
    return left + " = " + right + ";";
  }
}
