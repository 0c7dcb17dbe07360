package org.sitaf.core.combine;

import java.math.BigInteger;

/** A combination that would explode; refused before it is begun. */
public final class TooManyCombinationsException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final BigInteger count;

  /**
   * Refuses.
   *
   * @param what is too many
   */
  public TooManyCombinationsException(String what, BigInteger count, long limit) {
    super(
        what
            + ": "
            + count
            + ", more than the limit of "
            + limit
            + "; lower the strength, or give the parameters fewer values");
    this.count = count;
  }

  /** How many combinations there would be, exactly, conditions left out of account. */
  public BigInteger count() {
    return count;
  }
}
