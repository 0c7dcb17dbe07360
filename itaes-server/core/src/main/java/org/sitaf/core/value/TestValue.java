package org.sitaf.core.value;

import java.util.Objects;
import org.sitaf.core.model.Value;

/** A value that a test tries, and whether the specification declares it valid. */
public record TestValue(Value value, boolean valid) {
  public TestValue {
    Objects.requireNonNull(value);
  }
}
