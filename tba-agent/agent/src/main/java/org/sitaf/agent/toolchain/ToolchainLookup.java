package org.sitaf.agent.toolchain;

import java.util.Objects;

/** Result of the search for a toolchain on this machine. */
public sealed interface ToolchainLookup {
  /** The toolchain is installed. */
  record Found(Toolchain toolchain) implements ToolchainLookup {
    public Found {
      Objects.requireNonNull(toolchain);
    }
  }

  /**
   * The toolchain is missing or incomplete.
   *
   * @param reason what is missing, such as {@code g++ is installed, but gRPC's headers are missing}
   * @param remedy the command that installs it, or other advice
   */
  record Missing(String reason, String remedy) implements ToolchainLookup {
    public Missing {
      Objects.requireNonNull(reason);
      Objects.requireNonNull(remedy);
    }
  }
}
