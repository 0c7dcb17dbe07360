package org.sitaf.agent.toolchain;

import java.util.Objects;

/** What looking for a toolchain on this machine brought. */
public sealed interface ToolchainLookup {
  /** It is there. */
  record Found(Toolchain toolchain) implements ToolchainLookup {
    public Found {
      Objects.requireNonNull(toolchain);
    }
  }

  /**
   * It is not there, or not whole.
   *
   * @param reason what is missing, such as {@code g++ is there, gRPC's headers are not}
   * @param remedy the one command that installs it, or what else helps
   */
  record Missing(String reason, String remedy) implements ToolchainLookup {
    public Missing {
      Objects.requireNonNull(reason);
      Objects.requireNonNull(remedy);
    }
  }
}
