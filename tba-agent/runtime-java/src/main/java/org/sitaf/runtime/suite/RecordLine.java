package org.sitaf.runtime.suite;

import java.util.List;
import java.util.Locale;

/**
 * Prints one {@code case_record} or {@code step_record} element on one line
 * (docs/test-application.md, The record of a case).
 *
 * <p>Line breaks and tabs within values are written as character references. A character that XML
 * cannot hold is written as {@code &#92;u0000}; backslashes are not escaped.
 */
final class RecordLine {
  /** Longest message in characters; exceptions of components may have messages of any length. */
  private static final int MAX_MESSAGE_LENGTH = 8000;

  private final StringBuilder xml = new StringBuilder(256);
  private final String root;

  /** The record of a case. */
  RecordLine(int no, Outcome outcome) {
    root = "case_record";
    xml.append("<case_record no=\"")
        .append(no)
        .append("\" outcome=\"")
        .append(outcome)
        .append("\">");
  }

  /**
   * The record of a step.
   *
   * @param atNanos simulation time since the first step of the case
   */
  RecordLine(TestStep step, Outcome outcome, long atNanos) {
    root = "step_record";
    xml.append("<step_record no=\"")
        .append(step.no())
        .append("\" step=\"")
        .append(step.number())
        .append("\" name=\"");
    escape(step.name());
    xml.append("\" outcome=\"").append(outcome).append("\" at_ns=\"").append(atNanos).append("\">");
  }

  /** The name of the exception's type, without its package. */
  void thrown(String type) {
    element("thrown", "", type);
  }

  void actual(String output, String literal) {
    element("actual", output, literal);
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

  /** The times of repeated calls in nanoseconds, and how one of them differs. */
  void repeated(RepeatedCalls calls) {
    xml.append("<repeated_calls>");
    String before = "";
    for (long nanos : calls.nanos()) {
      xml.append(before).append(nanos);
      before = " ";
    }
    xml.append("</repeated_calls>");
    if (calls.differ()) {
      element("differs", "", calls.differs());
    }
  }

  /** Appends a non-negative number with three decimals; ten times as fast as String.format. */
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

  /** The values of an output data port; times are in nanoseconds since the call. */
  void port(String signal, List<PortChange> changes, long leftOut) {
    xml.append("<port name=\"");
    escape(signal);
    xml.append("\" left_out=\"").append(leftOut).append("\">");
    for (PortChange change : changes) {
      xml.append("<at ns=\"").append(change.nanos()).append("\">");
      escape(change.literal());
      xml.append("</at>");
    }
    xml.append("</port>");
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
    return xml.append("</").append(root).append(">\n").toString();
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

  /** Whether the text needs no escaping, which is true for almost all literals. */
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
      // Also the line separators of Unicode, for readers that split lines at them.
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

  /** Production Char of XML 1.0, without the characters handled before. */
  private static boolean isXml(int c) {
    return c >= 0x20 && c <= 0xD7FF || c >= 0xE000 && c <= 0xFFFD || c >= 0x10000;
  }
}
