package org.sitaf.cli.option;

import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestSuite;
import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Options of commands that generate test cases. */
public final class GenerationArguments {
  @Option(
      names = "--strength",
      paramLabel = "N|all",
      converter = StrengthConverter.class,
      description = "Order of combinations, 1 to 6 or all; default: that of the model.")
  private @Nullable Strength strength;

  @Option(
      names = "--max-cases",
      paramLabel = "N",
      converter = MaxCasesConverter.class,
      description =
          "Maximum number of cases: each value at least once, then as many combinations as fit;"
              + " default: that of the model.")
  private @Nullable Integer maxCases;

  @Option(
      names = "--effort",
      paramLabel = "fast|default|best",
      description = "How long to minimize the number of cases (default: default).")
  private @Nullable Effort effort;

  @Mixin private final SeedOption seed = new SeedOption();

  /** The seed of random values. */
  public long seed() {
    return seed.value();
  }

  /** Whether an option other than the seed is given. */
  public boolean changesModel() {
    return strength != null || maxCases != null || effort != null;
  }

  public GenerationOptions options() {
    return options(null, null);
  }

  public GenerationOptions options(
      @Nullable InvalidValues invalidValues, @Nullable TestSuite earlier) {
    return new GenerationOptions(
        strength,
        invalidValues,
        seed.value(),
        effort == null ? Effort.DEFAULT : effort,
        earlier,
        maxCases);
  }

  static final class StrengthConverter implements CommandLine.ITypeConverter<Strength> {
    @Override
    public Strength convert(String value) {
      try {
        return Strength.parse(value);
      } catch (IllegalArgumentException e) {
        throw new CommandLine.TypeConversionException(e.getMessage());
      }
    }
  }

  static final class MaxCasesConverter implements CommandLine.ITypeConverter<Integer> {
    @Override
    public Integer convert(String value) {
      try {
        int number = Integer.parseInt(value);
        if (number >= 1) {
          return number;
        }
      } catch (NumberFormatException e) {
        // Reported below.
      }
      throw new CommandLine.TypeConversionException(
          "must be a whole number from 1, not '" + value + "'");
    }
  }
}
