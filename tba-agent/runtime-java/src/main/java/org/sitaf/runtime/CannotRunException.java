package org.sitaf.runtime;

/**
 * The suite cannot be run at all, or cannot go on: a class or constructor is missing, the simulator
 * is gone. The process ends with exit code 3; nothing that a component under test does wrong
 * belongs here.
 */
public final class CannotRunException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** The message says what is missing and what to do, for a person. */
  public CannotRunException(String message) {
    super(message);
  }

  /** The message says what is missing and what to do, for a person. */
  public CannotRunException(String message, Throwable cause) {
    super(message, cause);
  }
}
