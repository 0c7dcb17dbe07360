package org.sitaf.core.suite.sequence;

import java.util.List;

/**
 * The values of all state variables.
 *
 * @param literals in the order of the model
 */
public record AbstractState(List<String> literals) {
  public AbstractState {
    literals = List.copyOf(literals);
  }
}
