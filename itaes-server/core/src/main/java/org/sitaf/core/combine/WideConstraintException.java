package org.sitaf.core.combine;

import java.math.BigInteger;
import java.util.Locale;

/** Thrown when a constraint relates too many combinations of values to be evaluated. */
public final class WideConstraintException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient Constraint constraint;

  /**
   * Creates an exception.
   *
   * @param combinations number of combinations of values of the parameters
   * @param limit the exceeded limit, as text
   */
  public WideConstraintException(Constraint constraint, BigInteger combinations, String limit) {
    super(
        String.format(
            Locale.ROOT,
            "relates %d parameters with %,d combinations of values, of which %s; split it with &&"
                + " or into several conditions with fewer parameters each",
            constraint.parameters().length,
            combinations,
            limit));
    this.constraint = constraint;
  }

  /** The rejected constraint. */
  public Constraint constraint() {
    return constraint;
  }
}
