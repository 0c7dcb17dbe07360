package org.sitaf.core.score.mutation;

import java.util.Objects;

/**
 * A change of a source file.
 *
 * @param path in the activity
 * @param line from 1
 * @param change such as {@code < replaced by <=}
 * @param start of the replaced text, in characters
 * @param end of the replaced text, in characters
 */
public record Mutation(
    String path, int line, String change, int start, int end, String replacement) {
  public Mutation {
    Objects.requireNonNull(path);
    Objects.requireNonNull(change);
    Objects.requireNonNull(replacement);
  }

  /** The file with the change. */
  public String applied(String source) {
    return source.substring(0, start) + replacement + source.substring(end);
  }

  /** The place in the activity. */
  public String where() {
    return path + ":" + line;
  }
}
