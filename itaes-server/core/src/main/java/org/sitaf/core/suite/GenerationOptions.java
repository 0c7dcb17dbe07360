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
 * @param maxCases null for the model's setting
 */
public record GenerationOptions(
    @Nullable Strength strength,
    @Nullable InvalidValues invalidValues,
    long seed,
    Effort effort,
    @Nullable TestSuite earlier,
    @Nullable Integer maxCases) {
  /** The settings of the model, with seed 1. */
  public static final GenerationOptions DEFAULT =
      new GenerationOptions(null, null, 1, Effort.DEFAULT, null, null);

  public GenerationOptions {
    Objects.requireNonNull(effort);
    if (maxCases != null && maxCases < 1) {
      throw new IllegalArgumentException("the maximum number of cases must be at least 1");
    }
  }

  /** Options without a bound. */
  public GenerationOptions(
      @Nullable Strength strength,
      @Nullable InvalidValues invalidValues,
      long seed,
      Effort effort,
      @Nullable TestSuite earlier) {
    this(strength, invalidValues, seed, effort, earlier, null);
  }

  /** Options without an earlier suite. */
  public GenerationOptions(
      @Nullable Strength strength,
      @Nullable InvalidValues invalidValues,
      long seed,
      Effort effort) {
    this(strength, invalidValues, seed, effort, null, null);
  }

  /** A copy with another seed. */
  public GenerationOptions withSeed(long other) {
    return new GenerationOptions(strength, invalidValues, other, effort, earlier, maxCases);
  }
}
