package org.sitaf.core.combine;

import java.util.Arrays;

/**
 * A demand: every tuple of {@code strength} values of {@code parameters} occurs in a row.
 *
 * @param strength how many parameters at a time, at least 1; more than there are means all of them
 * @param parameters distinct indices of parameters, from 0; kept in ascending order
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record Interaction(int strength, int[] parameters) {
  public Interaction {
    if (strength < 1) {
      throw new IllegalArgumentException(
          "the strength of an interaction is at least 1, not " + strength);
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
