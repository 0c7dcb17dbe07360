package org.sitaf.core.diagnostic;

import java.util.Objects;

/**
 * A problem in a user's input.
 *
 * @param severity whether the input can still be used
 * @param name of the document as the user knows it
 * @param line line in the document, from 1; 0 if unknown
 * @param element the affected element or entry, such as {@code test_element Distance/test_spec};
 *     empty for the whole document
 * @param message what is wrong, what was expected, and what to do
 */
public record Diagnostic(Severity severity, String file, int line, String element, String message) {

  public Diagnostic {
    Objects.requireNonNull(severity);
    Objects.requireNonNull(file);
    Objects.requireNonNull(element);
    Objects.requireNonNull(message);
    if (line < 0) {
      throw new IllegalArgumentException("line must not be negative: " + line);
    }
  }

  /** Creates an error. */
  public static Diagnostic error(String file, int line, String element, String message) {
    return new Diagnostic(Severity.ERROR, file, line, element, message);
  }

  /** Creates a warning. */
  public static Diagnostic warning(String file, int line, String element, String message) {
    return new Diagnostic(Severity.WARNING, file, line, element, message);
  }

  /**
   * This diagnostic, or one at a line and below an element if it has no line of its own.
   *
   * @param otherwise line in the document, from 1; 0 if unknown
   * @param parent the element that contains the affected one
   */
  public Diagnostic orAt(int otherwise, String parent) {
    return line > 0
        ? this
        : new Diagnostic(severity, file, otherwise, parent + "/" + element, message);
  }

  /** Returns the format of compilers: {@code file:line: error: element: message}. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(file);
    if (line > 0) {
      text.append(':').append(line);
    }
    text.append(": ").append(severity == Severity.ERROR ? "error" : "warning").append(": ");
    if (!element.isEmpty()) {
      text.append(element).append(": ");
    }
    return text.append(message).toString();
  }
}
