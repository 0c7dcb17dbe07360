package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Escapes values and texts of users in Python sources, and breaks lines as {@code ruff format}. */
final class PythonText {
  private static final int WIDTH = 88;
  private static final int MAX_DOCUMENTATION = 600;

  private PythonText() {}

  /** A string literal, in the quotes that need fewer escapes. */
  static String string(String text) {
    long doubles = text.chars().filter(c -> c == '"').count();
    long singles = text.chars().filter(c -> c == '\'').count();
    char quote = doubles > singles ? '\'' : '"';
    StringBuilder literal = new StringBuilder().append(quote);
    text.codePoints().forEach(c -> escape(literal, c, quote));
    return literal.append(quote).toString();
  }

  private static void escape(StringBuilder literal, int c, char quote) {
    if (c == quote || c == '\\') {
      literal.append('\\').append((char) c);
    } else if (c == '\n') {
      literal.append("\\n");
    } else if (c == '\r') {
      literal.append("\\r");
    } else if (c == '\t') {
      literal.append("\\t");
    } else if (c < 0x20 || c == 0x7f) {
      literal.append(String.format(Locale.ROOT, "\\x%02x", c));
    } else if (c < 0x7f || Character.isLetterOrDigit(c)) {
      literal.appendCodePoint(c);
    } else {
      literal.append(String.format(Locale.ROOT, c > 0xffff ? "\\U%08x" : "\\u%04x", c));
    }
  }

  /** A float literal, or an expression such as {@code float("nan")}. */
  static String real(double number) {
    if (Double.isNaN(number)) {
      return "float(\"nan\")";
    }
    if (Double.isInfinite(number)) {
      return number > 0 ? "float(\"inf\")" : "float(\"-inf\")";
    }
    return Double.toString(number).toLowerCase(Locale.ROOT);
  }

  /** Escapes a user's text for a docstring: a single line that cannot end the docstring. */
  static String plain(String text) {
    String oneLine =
        text.replaceAll("[\\s\\p{Cntrl}\\p{Cf}\\p{Cs}\\p{Co}\\p{Cn}\\p{Zl}\\p{Zp}]+", " ").strip();
    if (oneLine.length() > MAX_DOCUMENTATION) {
      oneLine = oneLine.substring(0, oneLine.offsetByCodePoints(0, MAX_DOCUMENTATION / 2)) + " ...";
    }
    return oneLine.replace("\\", "\\\\").replace('"', '\'');
  }

  /** A docstring of paragraphs. The first one is the summary. */
  static String docstring(int indent, List<String> paragraphs) {
    String pad = " ".repeat(indent);
    List<String> lines = new ArrayList<>();
    for (String paragraph : paragraphs) {
      if (!lines.isEmpty()) {
        lines.add("");
      }
      lines.addAll(wrapped(paragraph, WIDTH - indent - (lines.isEmpty() ? 6 : 0)));
    }
    if (lines.size() == 1) {
      return pad + "\"\"\"" + lines.get(0) + "\"\"\"";
    }
    StringBuilder text = new StringBuilder(pad + "\"\"\"" + lines.get(0));
    for (String line : lines.subList(1, lines.size())) {
      text.append('\n').append(line.isEmpty() ? "" : pad + line);
    }
    return text.append('\n').append(pad).append("\"\"\"").toString();
  }

  private static List<String> wrapped(String paragraph, int width) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : paragraph.split(" ")) {
      if (!line.isEmpty() && line.length() + 1 + word.length() > width) {
        lines.add(line.toString());
        line.setLength(0);
      }
      line.append(line.isEmpty() ? "" : " ").append(word);
    }
    lines.add(line.toString());
    return lines;
  }

  /**
   * A statement with a list in brackets, such as a call. It is broken if it does not fit on one
   * line.
   *
   * @param open text up to and including the opening bracket
   */
  record Group(String open, List<String> parts, String close) {
    Group {
      parts = List.copyOf(parts);
    }

    Group(String open, String close, String... parts) {
      this(open, Arrays.asList(parts), close);
    }

    String inline() {
      return open + String.join(", ", parts) + close;
    }

    /** The indented statement. */
    String at(int indent) {
      String pad = " ".repeat(indent);
      String inner = " ".repeat(indent + 4);
      if (parts.isEmpty() || indent + inline().length() <= WIDTH) {
        return pad + inline();
      }
      String together = String.join(", ", parts);
      StringBuilder text = new StringBuilder(pad).append(open).append('\n');
      if (inner.length() + together.length() <= WIDTH) {
        text.append(inner).append(together).append('\n');
      } else {
        parts.forEach(part -> text.append(inner).append(part).append(",\n"));
      }
      return text.append(pad).append(close).toString();
    }
  }
}
