package org.sitaf.core.verdict.document;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.timing.Timing;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.CaseResult.ProcessingTime;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.PortChanges;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.StubCalls;

/**
 * Reads the line that a test application writes when a case or a step has ended
 * (docs/test-application.md, The record of a case). The form is fixed, so reading takes a tenth of
 * the time of an XML parser; builds have a hundred thousand of these lines.
 */
public final class CaseRecordLine {
  private static final String STEP = "<step_record ";
  private static final int MAX_DIGITS = 15;
  private static final int MAX_DIGITS_OF_CASE = 9;

  private final String line;
  private final @Nullable Timing ordered;
  private int at;

  private CaseRecordLine(String line, @Nullable Timing ordered) {
    this.line = line;
    this.ordered = ordered;
  }

  /**
   * The record of a case.
   *
   * @throws InvalidInputException when the line is not a {@code case_record} element
   */
  public static CaseRecord read(String line) {
    return read(line, null);
  }

  /**
   * The record of a case whose call may have been repeated.
   *
   * @param ordered the repetitions that were ordered; a record with more of them is rejected
   * @throws InvalidInputException when the line is not a {@code case_record} element
   */
  public static CaseRecord read(String line, @Nullable Timing ordered) {
    return new CaseRecordLine(line, ordered).record();
  }

  /** Whether a line is the record of a step. */
  public static boolean isStep(String line) {
    return line.startsWith(STEP);
  }

  /**
   * The record of a step of a sequence.
   *
   * @throws InvalidInputException when the line is not a {@code step_record} element
   */
  public static StepRecord readStep(String line) {
    return new CaseRecordLine(line, null).step();
  }

  private StepRecord step() {
    expect(STEP + "no=\"");
    int no = (int) whole(MAX_DIGITS_OF_CASE);
    expect("\" step=\"");
    int number = (int) whole(MAX_DIGITS_OF_CASE);
    expect("\" name=\"");
    String name = text("\" outcome=\"");
    Outcome outcome = outcome();
    expect("\" at_ns=\"");
    long at = whole(MAX_DIGITS);
    expect("\">");
    return new StepRecord(number, name, at, content(no, outcome, "</step_record>"));
  }

  private CaseRecord record() {
    expect("<case_record no=\"");
    int no = (int) whole(MAX_DIGITS_OF_CASE);
    expect("\" outcome=\"");
    Outcome outcome = outcome();
    expect("\">");
    return content(no, outcome, "</case_record>");
  }

  private CaseRecord content(int no, Outcome outcome, String end) {
    String thrown = "";
    if (outcome == Outcome.THREW) {
      expect("<thrown>");
      thrown = text("</thrown>");
    }
    List<NamedValue> actual = values("actual");
    List<StubCalls.Call> calls = new ArrayList<>();
    while (skip("<call method=\"")) {
      String method = text("\">");
      calls.add(new StubCalls.Call(method, values("argument")));
      expect("</call>");
    }
    long leftOut = 0;
    if (skip("<calls_left_out>")) {
      leftOut = whole(MAX_DIGITS);
      expect("</calls_left_out>");
    }
    List<PortChanges> ports = ports();
    ProcessingTime time = time();
    RepeatedCalls repeated = repeated();
    String message = skip("<message>") ? text("</message>") : "";
    List<String> notes = new ArrayList<>();
    while (skip("<note>")) {
      notes.add(text("</note>"));
    }
    expect(end);
    if (at != line.length()) {
      throw invalid("nothing");
    }
    return new CaseRecord(
            no,
            outcome,
            thrown,
            actual,
            new StubCalls(calls, leftOut),
            time,
            repeated,
            message,
            notes)
        .withPorts(ports);
  }

  private Outcome outcome() {
    for (Outcome outcome : Outcome.values()) {
      if (skip(outcome.name())) {
        return outcome;
      }
    }
    throw invalid("an outcome");
  }

  private List<NamedValue> values(String element) {
    List<NamedValue> values = new ArrayList<>();
    String begin = "<" + element + " name=\"";
    String end = "</" + element + ">";
    while (skip(begin)) {
      String name = text("\">");
      values.add(new NamedValue(name, text(end)));
    }
    return values;
  }

  private List<PortChanges> ports() {
    List<PortChanges> ports = new ArrayList<>();
    while (skip("<port name=\"")) {
      String name = text("\" left_out=\"");
      long leftOut = whole(MAX_DIGITS);
      expect("\">");
      List<PortChanges.Change> changes = new ArrayList<>();
      while (skip("<at ns=\"")) {
        long sign = skip("-") ? -1 : 1;
        long nanos = sign * whole(MAX_DIGITS);
        expect("\">");
        changes.add(new PortChanges.Change(nanos, text("</at>")));
      }
      expect("</port>");
      ports.add(new PortChanges(name, changes, leftOut));
    }
    return ports;
  }

  private @Nullable ProcessingTime time() {
    if (!skip("<processing_time unit=\"us\" hardware=\"")) {
      return null;
    }
    double hardware = decimal();
    expect("\" stub=\"");
    double stub = decimal();
    expect("\">");
    double total = decimal();
    expect("</processing_time>");
    return new ProcessingTime(total, hardware, stub);
  }

  private @Nullable RepeatedCalls repeated() {
    if (ordered == null || !skip("<repeated_calls>")) {
      return null;
    }
    long[] nanos = new long[ordered.repeat()];
    int calls = 0;
    while (!skip("</repeated_calls>")) {
      if (calls > 0) {
        expect(" ");
      }
      if (calls == nanos.length) {
        throw invalid("at most " + nanos.length + " repeated calls");
      }
      nanos[calls++] = whole(MAX_DIGITS);
    }
    String differs = skip("<differs>") ? text("</differs>") : "";
    return RepeatedCalls.of(ordered.warmUp(), Arrays.copyOf(nanos, calls), differs);
  }

  private boolean skip(String part) {
    if (!line.startsWith(part, at)) {
      return false;
    }
    at += part.length();
    return true;
  }

  private void expect(String part) {
    if (!skip(part)) {
      throw invalid("'" + part + "'");
    }
  }

  private long whole(int maxDigits) {
    int from = at;
    long number = 0;
    while (at < line.length() && isDigit(line.charAt(at)) && at - from < maxDigits) {
      number = 10 * number + (line.charAt(at++) - '0');
    }
    if (at == from) {
      throw invalid("a number");
    }
    return number;
  }

  private double decimal() {
    int from = at;
    skip("-");
    whole(MAX_DIGITS);
    if (skip(".")) {
      whole(MAX_DIGITS);
    }
    return Double.parseDouble(line.substring(from, at));
  }

  private static boolean isDigit(char c) {
    return c >= '0' && c <= '9';
  }

  /** The text up to the given end, which is skipped. */
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
      appendNext(text);
    }
    return text.toString();
  }

  private void appendNext(StringBuilder text) {
    if (at == line.length()) {
      throw invalid("the end of the text");
    }
    char c = line.charAt(at);
    if (c == '&') {
      text.append(reference());
    } else if (isPlain(c)) {
      text.append(c);
      at++;
    } else if (Character.isHighSurrogate(c)
        && at + 1 < line.length()
        && Character.isLowSurrogate(line.charAt(at + 1))) {
      text.append(c).append(line.charAt(at + 1));
      at += 2;
    } else {
      throw invalid("a character that XML allows");
    }
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
    return switch ((int) code) {
      case '\n', '\r', '\t', 0x85, 0x2028, 0x2029 -> (char) code;
      default -> throw invalid("the reference of a line break or a tab");
    };
  }

  /** Whether the character is written unchanged and is not half of a surrogate pair. */
  private static boolean isPlain(char c) {
    return c >= ' '
        && c != '<'
        && c != '>'
        && c != '&'
        && c != '"'
        && !Character.isSurrogate(c)
        && c < 0xFFFE;
  }

  private InvalidInputException invalid(String expected) {
    return InvalidInputException.of(
        "results",
        "not a "
            + (isStep(line) ? "step" : "case")
            + "_record: at character "
            + (at + 1)
            + " expected "
            + expected);
  }
}
