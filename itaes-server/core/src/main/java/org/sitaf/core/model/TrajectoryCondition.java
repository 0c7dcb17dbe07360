package org.sitaf.core.model;

import java.util.Objects;

/**
 * A condition over time in signal temporal logic.
 *
 * @param fromSettle whether it begins with the settling before the call, rather than with the call
 * @param line line in the model, from 1; 0 if unknown
 */
public record TrajectoryCondition(String name, boolean fromSettle, String formula, int line) {
  public TrajectoryCondition {
    Objects.requireNonNull(name);
    Objects.requireNonNull(formula);
  }
}
