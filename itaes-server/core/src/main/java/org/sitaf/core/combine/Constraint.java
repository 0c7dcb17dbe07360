package org.sitaf.core.combine;

import java.util.Arrays;
import java.util.Objects;
import java.util.function.Predicate;

/**
 * A condition over some parameters that every row satisfies.
 *
 * @param parameters distinct indices of parameters, from 0, in the order of the values passed to
 *     {@code allowed}
 * @param allowed whether a row may contain these values; a pure function, evaluated once per tuple
 *     if there are at most {@link #MAX_TABLE}, else on demand
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record Constraint(int[] parameters, Predicate<int[]> allowed) {
  /**
   * Up to this number of tuples, the results are tabulated; otherwise the constraint is evaluated
   * on demand.
   */
  public static final long MAX_TABLE = 200_000;

  public Constraint {
    Objects.requireNonNull(allowed);
    parameters = parameters.clone();
    if (Arrays.stream(parameters).distinct().count() != parameters.length) {
      throw new IllegalArgumentException(
          "a constraint uses a parameter twice: " + Arrays.toString(parameters));
    }
  }

  /** Forbids a tuple of values. */
  public static Constraint forbid(int[] parameters, int[] values) {
    if (parameters.length != values.length) {
      throw new IllegalArgumentException(
          "the number of values must be the number of parameters: "
              + Arrays.toString(parameters)
              + " and "
              + Arrays.toString(values));
    }
    int[] forbidden = values.clone();
    return new Constraint(parameters, tuple -> !Arrays.equals(tuple, forbidden));
  }

  @Override
  public int[] parameters() {
    return parameters.clone();
  }
}
