package org.sitaf.core.expression;

import dev.cel.runtime.CelEvaluationException;

/** Messages of failed evaluations. */
final class Messages {
  private Messages() {}

  /** CEL's message without the position, which counts in the expression after its expansion. */
  static String of(CelEvaluationException e) {
    String message =
        String.valueOf(e.getMessage()).replaceFirst("^evaluation error(?: at \\S+)?: ", "");
    if (!message.startsWith("Function '")) {
      return message;
    }
    // A function's own message says more than the name of its overload.
    Throwable cause = e;
    while (cause.getCause() != null) {
      cause = cause.getCause();
    }
    return String.valueOf(cause.getMessage());
  }
}
