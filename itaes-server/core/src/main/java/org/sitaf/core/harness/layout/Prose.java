package org.sitaf.core.harness.layout;

import java.util.ArrayList;
import java.util.List;

/** Wraps paragraphs of comments. */
public final class Prose {
  private Prose() {}

  /**
   * Breaks a paragraph between words.
   *
   * @param first text before the first line
   * @param next text before the other lines
   * @param width the width of a line in columns; a longer word gets a line of its own
   */
  public static List<String> wrap(String paragraph, String first, String next, int width) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder(first);
    boolean empty = true;
    for (String word : paragraph.split(" ")) {
      if (!empty && line.length() + 1 + word.length() > width) {
        lines.add(line.toString());
        line = new StringBuilder(next);
        empty = true;
      }
      line.append(empty ? "" : " ").append(word);
      empty = false;
    }
    lines.add(line.toString());
    return lines;
  }
}
