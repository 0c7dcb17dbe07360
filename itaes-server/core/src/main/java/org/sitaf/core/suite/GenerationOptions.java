package org.sitaf.core.suite;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;

/**
 * What a person may choose beside the model.
 *
 * @param strength null to take the model's
 * @param invalidValues null to take the model's
 * @param seed of everything random
 * @param earlier a suite whose cases stay, so that only what is missing is added; null for none
 */
public record GenerationOptions(
    @Nullable Strength strength,
    @Nullable InvalidValues invalidValues,
    long seed,
    Effort effort,
    @Nullable TestSuite earlier) {
  /** As the model says, with the seed 1. */
  public static final GenerationOptions DEFAULT =
      new GenerationOptions(null, null, 1, Effort.DEFAULT, null);

  public GenerationOptions {
    Objects.requireNonNull(effort);
  }

  /** Choices without an earlier suite. */
  public GenerationOptions(
      @Nullable Strength strength,
      @Nullable InvalidValues invalidValues,
      long seed,
      Effort effort) {
    this(strength, invalidValues, seed, effort, null);
  }

  /** The same choices with another seed. */
  public GenerationOptions withSeed(long other) {
    return new GenerationOptions(strength, invalidValues, other, effort, earlier);
  }
}
