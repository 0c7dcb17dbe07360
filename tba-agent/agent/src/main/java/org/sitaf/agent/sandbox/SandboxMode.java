package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.util.Locale;

/** What a person asks for. */
public enum SandboxMode {
  /** Nothing of the user's runs outside of a sandbox. */
  REQUIRED,
  /** A sandbox where this machine has one. */
  AUTO,
  /** None: components run with this user's rights. */
  OFF;

  /**
   * The sandbox of this machine.
   *
   * @throws IOException when one is required and there is none, with what installs it
   */
  public Sandbox open() throws IOException {
    if (this == OFF) {
      return new NoSandbox("switched off");
    }
    try {
      return Bubblewrap.find(this == REQUIRED);
    } catch (SandboxMissingException e) {
      if (this == REQUIRED) {
        throw new IOException("--sandbox=required: " + e.getMessage(), e);
      }
      return new NoSandbox(String.valueOf(e.getMessage()));
    }
  }

  /** As the option spells it. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
