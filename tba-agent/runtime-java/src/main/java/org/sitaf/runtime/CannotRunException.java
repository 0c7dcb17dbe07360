package org.sitaf.runtime;

/**
 * The suite cannot run or cannot continue, for example because a class is missing or the simulator
 * is lost. The process ends with exit code 3. Failures of the component under test are results of
 * cases and never throw this exception.
 */
public final class CannotRunException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** The message says what is missing and what the user can do. */
  public CannotRunException(String message) {
    super(message);
  }

  /** The message says what is missing and what the user can do. */
  public CannotRunException(String message, Throwable cause) {
    super(message, cause);
  }
}
