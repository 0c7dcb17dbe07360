package org.sitaf.core.expression;

/** An expression has no value for these variables. */
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

  /** Whether the evaluation was ended because it took too much, so that others will, too. */
  public boolean tooCostly() {
    return tooCostly;
  }
}
