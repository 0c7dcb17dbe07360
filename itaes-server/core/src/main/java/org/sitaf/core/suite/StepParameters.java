package org.sitaf.core.suite;

import java.util.List;
import java.util.Objects;

/**
 * The parameters of a kind of step.
 *
 * @param name of the call or event
 * @param parameters none for an event
 */
public record StepParameters(String name, List<CaseParameter> parameters) {
  public StepParameters {
    Objects.requireNonNull(name);
    parameters = List.copyOf(parameters);
  }
}
