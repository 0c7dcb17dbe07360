package org.sitaf.core.combine;

import java.math.BigInteger;

/** Thrown before a combination that would be too large. */
public final class TooManyCombinationsException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final BigInteger count;

  /**
   * Creates an exception.
   *
   * @param what description of the counted items
   */
  public TooManyCombinationsException(String what, BigInteger count, long limit) {
    super(
        what
            + ": "
            + count
            + ", more than the limit of "
            + limit
            + "; reduce the strength or the number of values");
    this.count = count;
  }

  /** The exact count without constraints. */
  public BigInteger count() {
    return count;
  }
}
