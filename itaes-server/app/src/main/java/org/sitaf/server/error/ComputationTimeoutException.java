package org.sitaf.server.error;

/** A computation exceeded its time limit and was cancelled. */
public final class ComputationTimeoutException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public ComputationTimeoutException(String what, long limitSeconds) {
    super(
        what
            + " took longer than "
            + limitSeconds
            + " s and was cancelled: give the parameters fewer values, lower the strength, or"
            + " simplify the conditions");
  }
}
