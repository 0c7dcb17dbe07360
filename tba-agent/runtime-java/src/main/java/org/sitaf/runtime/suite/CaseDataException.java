package org.sitaf.runtime.suite;

/**
 * A test case or the suite that holds it cannot be read; the message names the value and what was
 * expected.
 */
public final class CaseDataException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  CaseDataException(String message) {
    super(message);
  }

  CaseDataException(String message, Throwable cause) {
    super(message, cause);
  }
}
