package org.sitaf.core.harness.cpp.syntax;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Escapes values and texts of users in C++ sources, and breaks lines as clang-format in Google
 * style with 100 columns.
 */
public final class CppText {
  private static final int WIDTH = 100;
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

  /** A wrapped documentation comment of escaped paragraphs. */
  public static String documentation(int indent, List<String> paragraphs) {
    List<String> lines = new ArrayList<>();
    String start = " ".repeat(indent) + "///";
    for (int i = 0; i < paragraphs.size(); i++) {
      if (i > 0) {
        lines.add(start);
      }
      wrap(lines, start + " ", paragraphs.get(i));
    }
    return String.join("\n", lines);
  }

  private static void wrap(List<String> lines, String start, String text) {
    StringBuilder line = new StringBuilder(start);
    boolean empty = true;
    for (String word : text.split(" ")) {
      if (!empty && line.length() + 1 + word.length() > WIDTH) {
        lines.add(line.toString());
        line = new StringBuilder(start);
        empty = true;
      }
      line.append(empty ? "" : " ").append(word);
      empty = false;
    }
    lines.add(line.toString());
  }

  /**
   * A call or a declaration with a list in brackets, on as few lines as possible.
   *
   * @param head text up to and including the opening bracket
   * @param tail text from the closing bracket on
   */
  public static String list(int indent, String head, List<String> parts, String tail) {
    String pad = " ".repeat(indent);
    String whole = pad + head + String.join(", ", parts) + tail;
    if (whole.length() <= WIDTH || parts.isEmpty()) {
      return whole;
    }
    int column = indent + head.length();
    int widest = parts.stream().mapToInt(String::length).max().orElse(0);
    if (column + widest + Math.max(1, tail.length()) <= WIDTH) {
      return pad + head + packed(column, parts, tail.length()) + tail;
    }
    return pad
        + head
        + "\n"
        + " ".repeat(indent + 4)
        + packed(indent + 4, parts, tail.length())
        + tail;
  }

  private static String packed(int column, List<String> parts, int tail) {
    StringBuilder text = new StringBuilder();
    int at = column;
    for (int i = 0; i < parts.size(); i++) {
      boolean last = i == parts.size() - 1;
      int needs = parts.get(i).length() + (last ? tail : 1);
      if (i > 0) {
        if (at + 1 + needs > WIDTH) {
          text.append("\n").append(" ".repeat(column));
          at = column;
        } else {
          text.append(' ');
          at++;
        }
      }
      text.append(parts.get(i)).append(last ? "" : ",");
      at += parts.get(i).length() + (last ? 0 : 1);
    }
    return text.toString();
  }

  /** A constructor that only initializes members. */
  public static String constructor(String head, List<String> initialisers) {
    String all = String.join(", ", initialisers) + " {}";
    if ((head + " : " + all).length() <= WIDTH) {
      return head + " : " + all;
    }
    return ("    : " + all).length() <= WIDTH
        ? head + "\n    : " + all
        : head + "\n    : " + String.join(",\n      ", initialisers) + " {}";
  }

  /** An assignment or declaration, with a line break after {@code =} if necessary. */
  public static String assignment(int indent, String left, String right) {
    String whole = " ".repeat(indent) + left + " = " + right + ";";
    return whole.length() <= WIDTH
        ? whole
        : " ".repeat(indent) + left + " =\n" + " ".repeat(indent + 4) + right + ";";
  }
}
