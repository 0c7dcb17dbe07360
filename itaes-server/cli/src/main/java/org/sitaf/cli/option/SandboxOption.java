package org.sitaf.cli.option;

import java.io.IOException;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import picocli.CommandLine.Option;

/** The sandbox of commands that execute a component. */
public final class SandboxOption {
  @Option(
      names = "--sandbox",
      paramLabel = "MODE",
      defaultValue = "auto",
      description =
          "The component runs in a sandbox (bubblewrap): required, auto (where it is installed) or"
              + " off; default: ${DEFAULT-VALUE}.")
  private SandboxMode mode = SandboxMode.AUTO;

  /** Whether a component must not run without a sandbox. */
  public boolean isRequired() {
    return mode == SandboxMode.REQUIRED;
  }

  /** Opens the sandbox. */
  public Sandbox open() throws IOException {
    return mode.open();
  }
}
