package org.sitaf.server.error;

/** A computation exceeded its time limit and was cancelled. */
public final class ComputationTimeoutException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public ComputationTimeoutException(String what, long limitSeconds) {
    super(
        what
            + " took longer than "
            + limitSeconds
            + " s and was cancelled: simplify the input; a test model needs fewer values, a lower"
            + " strength or simpler conditions, an interface or package fewer files");
  }
}
