package org.sitaf.agent.toolchain;

import java.util.Objects;

/**
 * An error message of a compiler.
 *
 * @param file path in the layout of the application, such as {@code activity/component/Foo.java};
 *     empty if it concerns no file
 * @param line from 1; 0 if unknown
 * @param column from 1; 0 if unknown
 * @param generated whether SITAF generated the file
 */
public record SourceDiagnostic(
    String file, int line, int column, String message, boolean generated) {
  public SourceDiagnostic {
    Objects.requireNonNull(file);
    Objects.requireNonNull(message);
    if (line < 0 || column < 0) {
      throw new IllegalArgumentException("line and column must not be negative");
    }
  }

  /** An error that concerns a whole file of the user. */
  public static SourceDiagnostic ofFile(String file, String message) {
    return new SourceDiagnostic(file, 0, 0, message, false);
  }

  /** The format of compilers: {@code file:line:column: error: message}. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    if (!file.isEmpty()) {
      text.append(file).append(':');
      if (line > 0) {
        text.append(line).append(':');
        if (column > 0) {
          text.append(column).append(':');
        }
      }
      text.append(' ');
    }
    return text.append("error: ").append(message).toString();
  }
}
