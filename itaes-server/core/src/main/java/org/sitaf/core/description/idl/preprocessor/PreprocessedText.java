package org.sitaf.core.description.idl.preprocessor;

import java.util.ArrayList;
import java.util.List;

/** The text that remains after preprocessing, with the origin of each of its lines. */
public final class PreprocessedText {
  /**
   * A line of a file.
   *
   * @param line from 1
   */
  public record Origin(String file, int line) {}

  private final StringBuilder text = new StringBuilder();
  private final List<Origin> origins = new ArrayList<>();
  private final Origin end;

  PreprocessedText(String file) {
    this.end = new Origin(file, 1);
  }

  void add(String line, String file, int number) {
    text.append(line).append('\n');
    origins.add(new Origin(file, number));
  }

  int length() {
    return text.length();
  }

  /** The text. */
  public String text() {
    return text.toString();
  }

  /**
   * The origin of a line of the text; the last one for a line beyond the end.
   *
   * @param line from 1
   */
  public Origin origin(int line) {
    if (origins.isEmpty()) {
      return end;
    }
    return origins.get(Math.min(Math.max(line, 1), origins.size()) - 1);
  }
}
