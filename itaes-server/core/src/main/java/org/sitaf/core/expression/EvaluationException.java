package org.sitaf.core.expression;

/** Thrown when an expression cannot be evaluated for the given variables. */
public final class EvaluationException extends Exception {
  private static final long serialVersionUID = 1L;

  private final boolean tooCostly;

  EvaluationException(String message) {
    this(message, false);
  }

  EvaluationException(String message, boolean tooCostly) {
    super(message);
    this.tooCostly = tooCostly;
  }

  /**
   * Whether the evaluation exceeded a limit; evaluations with other variables will most likely
   * exceed it, too.
   */
  public boolean tooCostly() {
    return tooCostly;
  }
}
