package org.sitaf.core.suite;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;

/**
 * Options of a generation.
 *
 * @param strength null for the model's strength
 * @param invalidValues null for the model's setting
 * @param seed seed of random values
 * @param earlier a suite whose cases are kept, so only missing cases are added; null for none
 */
public record GenerationOptions(
    @Nullable Strength strength,
    @Nullable InvalidValues invalidValues,
    long seed,
    Effort effort,
    @Nullable TestSuite earlier) {
  /** The settings of the model, with seed 1. */
  public static final GenerationOptions DEFAULT =
      new GenerationOptions(null, null, 1, Effort.DEFAULT, null);

  public GenerationOptions {
    Objects.requireNonNull(effort);
  }

  /** Options without an earlier suite. */
  public GenerationOptions(
      @Nullable Strength strength,
      @Nullable InvalidValues invalidValues,
      long seed,
      Effort effort) {
    this(strength, invalidValues, seed, effort, null);
  }

  /** A copy with another seed. */
  public GenerationOptions withSeed(long other) {
    return new GenerationOptions(strength, invalidValues, other, effort, earlier);
  }
}
