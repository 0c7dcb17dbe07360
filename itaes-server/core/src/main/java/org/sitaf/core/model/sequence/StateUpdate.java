package org.sitaf.core.model.sequence;

import java.util.Objects;

/**
 * What a step does to a variable of the abstract state.
 *
 * @param state name of the variable
 * @param expression CEL over the state before the step and the inputs of the call
 * @param line line in the model, from 1; 0 if unknown
 */
public record StateUpdate(String state, String expression, int line) {
  public StateUpdate {
    Objects.requireNonNull(state);
    Objects.requireNonNull(expression);
  }
}
