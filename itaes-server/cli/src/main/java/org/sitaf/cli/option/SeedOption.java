package org.sitaf.cli.option;

import picocli.CommandLine.Option;

/** The seed of commands that generate test cases. */
public final class SeedOption {
  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Seed of all random numbers (default: ${DEFAULT-VALUE}).")
  private long seed = 1;

  /** The seed. */
  public long value() {
    return seed;
  }
}
