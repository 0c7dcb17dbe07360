package org.sitaf.core.expression;

/** An expression has no value for these variables. */
public final class EvaluationException extends Exception {
  private static final long serialVersionUID = 1L;

  EvaluationException(String message) {
    super(message);
  }
}
