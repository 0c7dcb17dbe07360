package org.sitaf.core.description.idl.preprocessor;

import java.util.ArrayList;
import java.util.List;

/**
 * Splits a file into logical lines: lines that end with a backslash are joined, and each comment
 * becomes white space.
 */
final class LogicalLines {
  /**
   * A logical line.
   *
   * @param number of its first line in the file, from 1
   */
  record Line(int number, String text) {}

  private final String text;
  private final List<Line> lines = new ArrayList<>();
  private final StringBuilder current = new StringBuilder();
  private int at;
  private int line = 1;
  private int start = 1;

  private LogicalLines(String text) {
    this.text = text;
  }

  static List<Line> of(String text) {
    return new LogicalLines(text.replace("\r\n", "\n").replace('\r', '\n')).split();
  }

  private List<Line> split() {
    while (at < text.length()) {
      char c = text.charAt(at);
      if (text.startsWith("\\\n", at)) {
        at += 2;
        line++;
      } else if (text.startsWith("//", at)) {
        skipLineComment();
      } else if (text.startsWith("/*", at)) {
        skipBlockComment();
      } else if (c == '\n') {
        at++;
        end();
      } else if (c == '"' || c == '\'') {
        literal(c);
      } else {
        current.append(c);
        at++;
      }
    }
    end();
    return lines;
  }

  private void end() {
    lines.add(new Line(start, current.toString()));
    current.setLength(0);
    line++;
    start = line;
  }

  private void skipLineComment() {
    while (at < text.length() && text.charAt(at) != '\n') {
      if (text.startsWith("\\\n", at)) {
        at++;
        line++;
      }
      at++;
    }
    current.append(' ');
  }

  /** The lines of a comment belong to the logical line in which the comment begins. */
  private void skipBlockComment() {
    int end = text.indexOf("*/", at + 2);
    int stop = end < 0 ? text.length() : end + 2;
    String comment = text.substring(at, stop);
    line += (int) comment.chars().filter(c -> c == '\n').count();
    // What follows a comment keeps its column.
    current.append(" ".repeat(comment.length() - comment.lastIndexOf('\n') - 1));
    current.append(comment.contains("\n") ? " " : "");
    at = stop;
  }

  /**
   * A quote without an end, such as an apostrophe in a section that is left out, ends with the
   * line.
   */
  private void literal(char quote) {
    current.append(quote);
    at++;
    while (at < text.length() && text.charAt(at) != '\n') {
      char c = text.charAt(at);
      if (text.startsWith("\\\n", at)) {
        at += 2;
        line++;
        continue;
      }
      current.append(c);
      at++;
      if (c == '\\' && at < text.length() && text.charAt(at) != '\n') {
        current.append(text.charAt(at));
        at++;
      } else if (c == quote) {
        return;
      }
    }
  }
}
