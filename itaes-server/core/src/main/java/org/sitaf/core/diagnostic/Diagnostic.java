package org.sitaf.core.diagnostic;

import java.util.Objects;

/**
 * One thing that is wrong with an input.
 *
 * @param severity whether the input can still be used
 * @param file name of the document, as the user knows it
 * @param line line in the document, from 1; 0 where it is unknown
 * @param element the element or entry concerned, such as {@code test_element Distance/test_spec};
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

  /** An error at a line of a document. */
  public static Diagnostic error(String file, int line, String element, String message) {
    return new Diagnostic(Severity.ERROR, file, line, element, message);
  }

  /** A warning at a line of a document. */
  public static Diagnostic warning(String file, int line, String element, String message) {
    return new Diagnostic(Severity.WARNING, file, line, element, message);
  }

  /** As compilers print it: {@code file:line: error: element: message}. */
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
