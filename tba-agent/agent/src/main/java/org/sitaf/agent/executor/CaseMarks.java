package org.sitaf.agent.executor;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Removes marks from the output of a test application. A mark tells which case prints: U+001E,
 * {@code case NO} and a line feed. One instance per stream; a mark may be split among reads.
 */
final class CaseMarks {
  private static final char MARK = '\u001e';
  private static final Pattern CASE = Pattern.compile("case (\\d{1,9})");
  private static final int MAX_LENGTH = "case 999999999".length();

  private final StringBuilder mark = new StringBuilder();
  private final Reader reader;
  private boolean inMark;
  private int current;

  /** Receives the text without marks. */
  interface Reader {
    /** A piece of text; case 0 means outside of cases. */
    void text(String text, int caseNo);
  }

  CaseMarks(Reader reader) {
    this.reader = reader;
  }

  void read(String text) {
    int from = 0;
    while (from < text.length()) {
      if (inMark) {
        from = readMark(text, from);
      } else {
        int at = text.indexOf(MARK, from);
        int end = at < 0 ? text.length() : at;
        if (end > from) {
          reader.text(text.substring(from, end), current);
        }
        inMark = at >= 0;
        from = at < 0 ? end : at + 1;
      }
    }
  }

  /** Continues a mark; invalid marks are treated as text. */
  private int readMark(String text, int from) {
    int at = from;
    while (at < text.length()) {
      char c = text.charAt(at);
      if (c == '\n') {
        Matcher found = CASE.matcher(mark);
        if (!found.matches()) {
          break;
        }
        current = Integer.parseInt(found.group(1));
        endMark();
        return at + 1;
      }
      if (mark.length() == MAX_LENGTH || c == MARK) {
        break;
      }
      mark.append(c);
      at++;
    }
    if (at < text.length()) {
      reader.text(MARK + mark.toString(), current);
      endMark();
    }
    return at;
  }

  private void endMark() {
    mark.setLength(0);
    inMark = false;
  }
}
