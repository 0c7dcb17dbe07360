package org.sitaf.core.suite;

import java.util.Objects;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;

/**
 * The settings of a generation. The same model and settings give the same cases.
 *
 * @param effort fast, default or best
 * @param generator name and version of the generator
 */
public record Generation(
    Strength strength, InvalidValues invalidValues, long seed, String effort, String generator) {
  public Generation {
    Objects.requireNonNull(strength);
    Objects.requireNonNull(invalidValues);
    Objects.requireNonNull(effort);
    Objects.requireNonNull(generator);
  }
}
