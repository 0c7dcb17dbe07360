package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.util.Locale;

/** Value of the option {@code --sandbox}. */
public enum SandboxMode {
  /** Refuse to run without a sandbox. */
  REQUIRED,
  /** Use a sandbox if this machine has one. */
  AUTO,
  /** Run components with this user's rights. */
  OFF;

  /**
   * The sandbox of this machine.
   *
   * @throws IOException if one is required and missing; the message says what to install
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

  /** The value as written in the option. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
