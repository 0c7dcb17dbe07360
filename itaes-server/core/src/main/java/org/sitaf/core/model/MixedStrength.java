package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;

/** A separate strength for combinations of the given parameters. */
public record MixedStrength(Strength strength, List<String> parameters) {
  public MixedStrength {
    Objects.requireNonNull(strength);
    parameters = List.copyOf(parameters);
  }
}
