package org.sitaf.core.suite;

import java.util.Objects;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;

/**
 * How cases were made; the same model and the same settings give the same cases.
 *
 * @param effort fast, default or best
 * @param generator program and version
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
