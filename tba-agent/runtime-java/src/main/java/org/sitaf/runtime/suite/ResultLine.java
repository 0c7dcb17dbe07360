package org.sitaf.runtime.suite;

import java.util.List;
import java.util.Locale;

/**
 * Prints one {@code test_result} element (paper, Fig. 11) on one line.
 *
 * <p>Line breaks and the like inside of values are written as character references. A character
 * that XML cannot hold at all is written as in a Java string, {@code &#92;u0000}; backslashes
 * themselves stay as they are.
 */
final class ResultLine {
  /** Longest message; what a component puts into an exception has no bound of its own. */
  private static final int MAX_MESSAGE_LENGTH = 8000;

  private final StringBuilder xml = new StringBuilder(256);

  void open(int no, Verdict verdict) {
    xml.append("<test_result no=\"")
        .append(no)
        .append("\" verdict=\"")
        .append(verdict)
        .append("\">");
  }

  void value(String literal) {
    element("value", "", literal);
  }

  /** An expected or actual value; an empty name means the only output. */
  void output(String element, String name, String literal) {
    element(element, name, literal);
  }

  void time(CaseResult.ProcessingTime time) {
    xml.append("<processing_time unit=\"us\" hardware=\"");
    thousandths(time.hardware());
    xml.append("\" stub=\"");
    thousandths(time.stub());
    xml.append("\">");
    thousandths(time.component());
    xml.append("</processing_time>");
  }

  /** Three decimals of a number that is not negative; a format string would cost ten times that. */
  private void thousandths(double number) {
    long rounded = Math.round(number * 1000);
    xml.append(rounded / 1000).append('.');
    String decimals = Long.toString(rounded % 1000);
    xml.append("000", 0, 3 - decimals.length()).append(decimals);
  }

  /** A call of a required interface. */
  void call(String method, List<String> parameters, List<String> arguments) {
    xml.append("<call method=\"");
    escape(method);
    xml.append("\">");
    for (int i = 0; i < Math.min(parameters.size(), arguments.size()); i++) {
      element("argument", parameters.get(i), arguments.get(i));
    }
    xml.append("</call>");
  }

  void callsLeftOut(long count) {
    element("calls_left_out", "", Long.toString(count));
  }

  void message(String text) {
    element(
        "message",
        "",
        text.length() <= MAX_MESSAGE_LENGTH
            ? text
            : text.substring(0, MAX_MESSAGE_LENGTH) + " ... (" + text.length() + " characters)");
  }

  String close() {
    return xml.append("</test_result>\n").toString();
  }

  private void element(String element, String name, String content) {
    xml.append('<').append(element);
    if (!name.isEmpty()) {
      xml.append(" name=\"");
      escape(name);
      xml.append('"');
    }
    xml.append('>');
    escape(content);
    xml.append("</").append(element).append('>');
  }

  private void escape(String text) {
    if (isPlain(text)) {
      xml.append(text);
      return;
    }
    for (int i = 0; i < text.length(); i += Character.charCount(text.codePointAt(i))) {
      escape(text.codePointAt(i));
    }
  }

  /** Whether there is nothing to escape, as in almost all literals. */
  private static boolean isPlain(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c < ' ' || c > '~' || c == '&' || c == '<' || c == '>' || c == '"') {
        return false;
      }
    }
    return true;
  }

  private void escape(int c) {
    switch (c) {
      case '&' -> xml.append("&amp;");
      case '<' -> xml.append("&lt;");
      case '>' -> xml.append("&gt;");
      case '"' -> xml.append("&quot;");
      // A reader that splits lines by Unicode's rules must find one line, too.
      case '\n', '\r', '\t', 0x85, 0x2028, 0x2029 -> xml.append("&#").append(c).append(';');
      default -> {
        if (isXml(c)) {
          xml.appendCodePoint(c);
        } else {
          xml.append(String.format(Locale.ROOT, "\\u%04X", c));
        }
      }
    }
  }

  /** Char of XML 1.0, less what is handled before. */
  private static boolean isXml(int c) {
    return c >= 0x20 && c <= 0xD7FF || c >= 0xE000 && c <= 0xFFFD || c >= 0x10000;
  }
}
