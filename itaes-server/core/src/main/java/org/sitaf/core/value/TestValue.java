package org.sitaf.core.value;

import java.util.Objects;
import org.sitaf.core.model.Value;

/** A test value, and whether it is valid by the specification. */
public record TestValue(Value value, boolean valid) {
  public TestValue {
    Objects.requireNonNull(value);
  }
}
