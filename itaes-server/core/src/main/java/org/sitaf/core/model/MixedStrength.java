package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;

/** A strength of its own for some parameters among each other. */
public record MixedStrength(Strength strength, List<String> parameters) {
  public MixedStrength {
    Objects.requireNonNull(strength);
    parameters = List.copyOf(parameters);
  }
}
