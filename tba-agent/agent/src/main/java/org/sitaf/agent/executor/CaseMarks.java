package org.sitaf.agent.executor;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Takes the marks out of what a test application prints, by which it says which case prints:
 * U+001E, {@code case NO} and a line feed. For one stream; a mark may come in pieces.
 */
final class CaseMarks {
  private static final char MARK = '\u001e';
  private static final Pattern CASE = Pattern.compile("case (\\d{1,9})");
  private static final int LONGEST = "case 999999999".length();

  private final StringBuilder mark = new StringBuilder();
  private final Reader reader;
  private boolean inMark;
  private int current;

  /** Is told the text without marks. */
  interface Reader {
    /** Some of it; the case is 0 where none prints. */
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

  /** Reads on in a mark; what turns out to be none is text like all other. */
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
      if (mark.length() == LONGEST || c == MARK) {
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
