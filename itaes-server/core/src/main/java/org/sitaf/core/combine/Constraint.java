package org.sitaf.core.combine;

import java.util.Arrays;
import java.util.Objects;
import java.util.function.Predicate;

/**
 * A condition that every row keeps, over the values of a few parameters.
 *
 * @param parameters distinct indices of parameters, from 0, in the order in which {@code allowed}
 *     takes their values
 * @param allowed whether these values may stand together in a row; a pure function, asked once for
 *     every tuple where there are few enough, else as needed
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record Constraint(int[] parameters, Predicate<int[]> allowed) {
  /** Up to this many tuples are tabulated; beyond, a constraint is asked as needed. */
  public static final long MAX_TABLE = 200_000;

  public Constraint {
    Objects.requireNonNull(allowed);
    parameters = parameters.clone();
    if (Arrays.stream(parameters).distinct().count() != parameters.length) {
      throw new IllegalArgumentException(
          "a constraint names a parameter twice: " + Arrays.toString(parameters));
    }
  }

  /** The constraint that these values of these parameters never stand together. */
  public static Constraint forbid(int[] parameters, int[] values) {
    if (parameters.length != values.length) {
      throw new IllegalArgumentException(
          "as many values as parameters are needed: "
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
