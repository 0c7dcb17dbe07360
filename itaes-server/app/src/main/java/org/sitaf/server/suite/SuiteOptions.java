package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.server.error.RequestException;

/** Options of the generator; absent ones are taken from the model. */
@Schema(name = "SuiteOptions")
record SuiteOptions(
    @Schema(description = "default 1") @Nullable Long seed,
    @Schema(description = "1 to 6, or all") @Nullable String orderOfCombinations,
    @Nullable Handling invalidValues,
    @Schema(description = "maximum number of all cases, at least 1") @Nullable Integer maxCases) {

  /** How invalid values are combined. */
  enum Handling {
    isolate,
    combine
  }

  static final SuiteOptions NONE = new SuiteOptions(null, null, null, null);

  GenerationOptions toGeneration() {
    if (maxCases != null && maxCases < 1) {
      throw RequestException.malformed("maxCases must be at least 1, not " + maxCases + ".");
    }
    try {
      return new GenerationOptions(
          orderOfCombinations == null ? null : Strength.parse(orderOfCombinations),
          invalidValues == null
              ? null
              : invalidValues == Handling.isolate ? InvalidValues.ISOLATE : InvalidValues.COMBINE,
          seed == null ? GenerationOptions.DEFAULT.seed() : seed,
          GenerationOptions.DEFAULT.effort(),
          null,
          maxCases);
    } catch (IllegalArgumentException e) {
      throw RequestException.malformed("orderOfCombinations: " + e.getMessage() + ".");
    }
  }
}
