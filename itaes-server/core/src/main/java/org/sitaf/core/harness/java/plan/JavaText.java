package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Escapes values and texts of users in Java sources. Java treats {@code &#92;u000a} as a line break
 * everywhere, even in a comment, so every backslash must be escaped.
 */
public final class JavaText {
  private static final int WIDTH = 100;
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
   * A wrapped documentation comment of escaped texts.
   *
   * @param indent indentation in columns
   * @param tags block tags, such as {@code @param name description}
   */
  public static String javadoc(int indent, List<String> paragraphs, List<String> tags) {
    String pad = " ".repeat(indent);
    String only = pad + "/** " + paragraphs.get(0) + " */";
    if (paragraphs.size() == 1 && tags.isEmpty() && only.length() <= WIDTH) {
      return only;
    }
    List<String> lines = new ArrayList<>();
    lines.add(pad + "/**");
    for (int i = 0; i < paragraphs.size(); i++) {
      if (i > 0) {
        lines.add(pad + " *");
      }
      wrap(lines, pad + " * ", (i > 0 ? "<p>" : "") + paragraphs.get(i), "");
    }
    for (int i = 0; i < tags.size(); i++) {
      if (i == 0) {
        lines.add(pad + " *");
      }
      wrap(lines, pad + " * ", tags.get(i), "    ");
    }
    lines.add(pad + " */");
    return String.join("\n", lines);
  }

  private static void wrap(List<String> lines, String start, String text, String continuation) {
    StringBuilder line = new StringBuilder(start);
    boolean empty = true;
    for (String word : text.split(" ")) {
      if (!empty && line.length() + 1 + word.length() > WIDTH) {
        lines.add(line.toString());
        line = new StringBuilder(start).append(continuation);
        empty = true;
      }
      line.append(empty ? "" : " ").append(word);
      empty = false;
    }
    lines.add(line.toString());
  }

  /**
   * A call statement, with line breaks as in google-java-format.
   *
   * @param left text before the call: empty, {@code return} or an assignment ending with {@code =}
   */
  public static String call(int indent, String left, String callee, List<String> arguments) {
    String pad = " ".repeat(indent);
    String before = left.isEmpty() ? "" : left + " ";
    String whole = pad + before + callee + "(" + String.join(", ", arguments) + ");";
    if (whole.length() <= WIDTH) {
      return whole;
    }
    if (left.endsWith("=")) {
      return pad + left + "\n" + call(indent + 4, "", callee, arguments);
    }
    return pad + before + callee + "(" + broken(indent, arguments) + ");";
  }

  /**
   * A method declaration, with line breaks as in google-java-format.
   *
   * @param end text after the declaration, such as {@code ;}
   */
  public static String declaration(
      int indent, String head, List<String> parameters, boolean throwing, String end) {
    String pad = " ".repeat(indent);
    String oneLine = pad + head + "(" + String.join(", ", parameters) + ")";
    String clause = throwing ? " throws Exception" : "";
    if ((oneLine + clause + end).length() <= WIDTH) {
      return oneLine + clause + end;
    }
    if (throwing && oneLine.length() <= WIDTH) {
      return oneLine + "\n" + pad + "    throws Exception" + end;
    }
    String rest = throwing ? ")\n" + pad + "    throws Exception" + end : ")" + end;
    return pad + head + "(" + broken(indent, parameters) + rest;
  }

  private static String broken(int indent, List<String> parts) {
    String pad = "\n" + " ".repeat(indent + 4);
    String together = String.join(", ", parts);
    // Two columns are reserved for the end of the list.
    return pad
        + (indent + 4 + together.length() + 2 <= WIDTH ? together : String.join("," + pad, parts));
  }
}
