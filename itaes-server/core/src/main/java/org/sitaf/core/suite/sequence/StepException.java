package org.sitaf.core.suite.sequence;

/** Thrown if a guard or an update cannot be evaluated. */
final class StepException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int line;
  private final String where;

  StepException(int line, String where, String message) {
    super(message);
    this.line = line;
    this.where = where;
  }

  int line() {
    return line;
  }

  String where() {
    return where;
  }
}
