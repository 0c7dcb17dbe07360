package org.sitaf.core.description;

import java.util.Objects;

/** A parameter of a method. */
public record Parameter(String name, DataType type, Direction direction) {
  public Parameter {
    Objects.requireNonNull(name);
    Objects.requireNonNull(type);
    Objects.requireNonNull(direction);
  }
}
