package org.sitaf.core.combine;

import java.math.BigInteger;
import java.util.Locale;

/** A constraint over so many combinations of values that it cannot be judged by trying them. */
public final class WideConstraintException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient Constraint constraint;

  /**
   * Refuses a constraint.
   *
   * @param combinations of values of its parameters
   * @param limit what trying them reached
   */
  public WideConstraintException(Constraint constraint, BigInteger combinations, String limit) {
    super(
        String.format(
            Locale.ROOT,
            "relates %d parameters with %,d combinations of values, of which %s; split it with &&,"
                + " or into several conditions, of fewer parameters each",
            constraint.parameters().length,
            combinations,
            limit));
    this.constraint = constraint;
  }

  /** The constraint. */
  public Constraint constraint() {
    return constraint;
  }
}
