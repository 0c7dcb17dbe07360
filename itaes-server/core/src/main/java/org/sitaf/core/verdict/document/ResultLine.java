package org.sitaf.core.verdict.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.Verdict;

/**
 * Reads the line of a case in the one spelling that the runtimes of test applications write, in a
 * tenth of the time that any XML takes. Whatever else is XML, or is none, is not known here.
 */
final class ResultLine {
  private static final int LONGEST_NUMBER = 15;

  private final String line;
  private int at;

  private ResultLine(String line) {
    this.line = line;
  }

  /** Where a line stops to be spelled so; no stack, as it is no failure. */
  private static final class SpelledOtherwise extends RuntimeException {
    private static final long serialVersionUID = 1L;
    private static final SpelledOtherwise HERE = new SpelledOtherwise();

    private SpelledOtherwise() {
      super("", null, false, false);
    }
  }

  /** The result; empty where the line is not spelled as the runtimes do. */
  static Optional<CaseResult> read(String line) {
    try {
      return Optional.of(new ResultLine(line).result());
    } catch (SpelledOtherwise e) {
      return Optional.empty();
    }
  }

  private CaseResult result() {
    expect("<test_result no=\"");
    int no = (int) whole(9);
    expect("\" verdict=\"");
    Verdict verdict = verdict();
    expect("\">");
    List<String> values = new ArrayList<>();
    while (skip("<value>")) {
      values.add(text("</value>"));
    }
    List<NamedValue> expected = named("expected");
    List<NamedValue> actual = named("actual");
    List<StubCalls.Call> calls = new ArrayList<>();
    while (skip("<call method=\"")) {
      String method = name();
      calls.add(new StubCalls.Call(method, named("argument")));
      expect("</call>");
    }
    long leftOut = 0;
    if (skip("<calls_left_out>")) {
      leftOut = whole(LONGEST_NUMBER);
      expect("</calls_left_out>");
    }
    CaseResult.ProcessingTime time = time();
    String message = skip("<message>") ? text("</message>") : "";
    expect("</test_result>");
    if (at != line.length()) {
      throw SpelledOtherwise.HERE;
    }
    return new CaseResult(
        no, verdict, values, expected, actual, new StubCalls(calls, leftOut), time, message);
  }

  private Verdict verdict() {
    for (Verdict verdict : Verdict.values()) {
      if (skip(verdict.name())) {
        return verdict;
      }
    }
    throw SpelledOtherwise.HERE;
  }

  private List<NamedValue> named(String element) {
    List<NamedValue> values = new ArrayList<>();
    String end = "</" + element + ">";
    while (line.startsWith(element, at + 1) && skip("<")) {
      at += element.length();
      String name = skip(" name=\"") ? name() : unnamed();
      values.add(new NamedValue(name, text(end)));
    }
    return values;
  }

  private String unnamed() {
    expect(">");
    return "";
  }

  private CaseResult.@Nullable ProcessingTime time() {
    if (!skip("<processing_time unit=\"us\" hardware=\"")) {
      return null;
    }
    double hardware = decimal();
    expect("\" stub=\"");
    double stub = decimal();
    expect("\">");
    double total = decimal();
    expect("</processing_time>");
    return new CaseResult.ProcessingTime(total, hardware, stub);
  }

  private boolean skip(String what) {
    if (!line.startsWith(what, at)) {
      return false;
    }
    at += what.length();
    return true;
  }

  private void expect(String what) {
    if (!skip(what)) {
      throw SpelledOtherwise.HERE;
    }
  }

  /** A whole number that is not negative, of at most so many digits. */
  private long whole(int digits) {
    int from = at;
    long number = 0;
    while (at < line.length() && isDigit(line.charAt(at))) {
      number = 10 * number + (line.charAt(at++) - '0');
      if (at - from > digits) {
        throw SpelledOtherwise.HERE;
      }
    }
    if (at == from) {
      throw SpelledOtherwise.HERE;
    }
    return number;
  }

  private double decimal() {
    int from = at;
    whole(LONGEST_NUMBER);
    if (skip(".")) {
      whole(LONGEST_NUMBER);
    }
    return Double.parseDouble(line.substring(from, at));
  }

  private static boolean isDigit(char c) {
    return c >= '0' && c <= '9';
  }

  /** An attribute, whose spaces a schema may collapse: with any, it is not read here. */
  private String name() {
    String name = text("\">");
    for (int i = 0; i < name.length(); i++) {
      if (name.charAt(i) <= ' ') {
        throw SpelledOtherwise.HERE;
      }
    }
    return name;
  }

  /** What stands before the given end, which is skipped too. */
  private String text(String end) {
    int from = at;
    while (at < line.length() && isPlain(line.charAt(at))) {
      at++;
    }
    String plain = line.substring(from, at);
    if (skip(end)) {
      return plain;
    }
    StringBuilder text = new StringBuilder(plain);
    while (!skip(end)) {
      text.append(next());
    }
    return text.toString();
  }

  private char next() {
    if (at == line.length()) {
      throw SpelledOtherwise.HERE;
    }
    char c = line.charAt(at);
    if (c == '&') {
      return reference();
    }
    if (!isPlain(c)) {
      throw SpelledOtherwise.HERE;
    }
    at++;
    return c;
  }

  private char reference() {
    if (skip("&amp;")) {
      return '&';
    }
    if (skip("&lt;")) {
      return '<';
    }
    if (skip("&gt;")) {
      return '>';
    }
    if (skip("&quot;")) {
      return '"';
    }
    expect("&#");
    long code = whole(4);
    expect(";");
    boolean known =
        code == '\n'
            || code == '\r'
            || code == '\t'
            || code == 0x85
            || code == 0x2028
            || code == 0x2029;
    if (!known) {
      throw SpelledOtherwise.HERE;
    }
    return (char) code;
  }

  /** Stands for itself in XML, in text and in attributes; pairs of surrogates do not here. */
  private static boolean isPlain(char c) {
    return c >= ' '
        && c != '<'
        && c != '>'
        && c != '&'
        && c != '"'
        && (c < Character.MIN_SURROGATE || c > Character.MAX_SURROGATE)
        && c < 0xFFFE;
  }
}
