package org.sitaf.core.combine;

import java.util.Arrays;

/**
 * Requires that every tuple of {@code strength} values of {@code parameters} occurs in a row.
 *
 * @param strength number of parameters per tuple, at least 1; limited to the number of parameters
 * @param parameters distinct indices of parameters, from 0; stored in ascending order
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record Interaction(int strength, int[] parameters) {
  public Interaction {
    if (strength < 1) {
      throw new IllegalArgumentException(
          "the strength of an interaction must be at least 1, not " + strength);
    }
    parameters = parameters.clone();
    Arrays.sort(parameters);
    for (int i = 1; i < parameters.length; i++) {
      if (parameters[i] == parameters[i - 1]) {
        throw new IllegalArgumentException(
            "parameter " + parameters[i] + " occurs twice in an interaction");
      }
    }
  }

  @Override
  public int[] parameters() {
    return parameters.clone();
  }
}
