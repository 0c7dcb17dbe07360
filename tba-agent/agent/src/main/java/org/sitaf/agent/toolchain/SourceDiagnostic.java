package org.sitaf.agent.toolchain;

import java.util.Objects;

/**
 * What a compiler says of a file of the test application.
 *
 * @param file path in the layout of the application, such as {@code activity/component/Foo.java};
 *     empty where no file is concerned
 * @param line from 1; 0 where it is unknown
 * @param column from 1; 0 where it is unknown
 * @param generated in a file that SITAF generated, not in one of the user
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

  /** Says something of a whole file of the user. */
  public static SourceDiagnostic ofFile(String file, String message) {
    return new SourceDiagnostic(file, 0, 0, message, false);
  }

  /** As compilers print it: {@code file:line:column: error: message}. */
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
