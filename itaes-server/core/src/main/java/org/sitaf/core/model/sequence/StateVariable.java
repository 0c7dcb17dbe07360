package org.sitaf.core.model.sequence;

import java.util.Objects;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.Value;

/**
 * A variable of the abstract state.
 *
 * @param realType type as written in the model
 * @param type resolved type
 * @param initial value before the first step
 * @param line line in the model, from 1; 0 if unknown
 */
public record StateVariable(String name, String realType, DataType type, Value initial, int line) {
  public StateVariable {
    Objects.requireNonNull(name);
    Objects.requireNonNull(realType);
    Objects.requireNonNull(type);
    Objects.requireNonNull(initial);
  }

  /** A copy with another resolved type. */
  public StateVariable withType(DataType resolved) {
    return new StateVariable(name, realType, resolved, initial, line);
  }
}
