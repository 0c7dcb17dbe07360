package org.sitaf.core.harness.python;

import java.util.List;
import java.util.Locale;

/** Escapes values and texts of users in Python sources. */
final class PythonText {
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

  /**
   * A list in brackets, such as a call.
   *
   * @param open text up to and including the opening bracket
   * @param close text from the closing bracket on
   */
  static String list(String open, List<String> parts, String close) {
    return open + String.join(", ", parts) + close;
  }
}
