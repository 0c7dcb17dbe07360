package org.sitaf.agent.sandbox;

import java.io.IOException;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;

/**
 * Runs processes with the agent's own rights, but without the agent's environment.
 *
 * @param reason why there is no sandbox
 */
record NoSandbox(String reason) implements Sandbox {
  @Override
  public String kind() {
    return NONE;
  }

  @Override
  public String description() {
    return "no sandbox: " + reason;
  }

  @Override
  public boolean isRequired() {
    return false;
  }

  @Override
  public boolean canIdle() {
    return false;
  }

  @Override
  public ConfinedProcess start(Confinement confinement) throws IOException {
    return ConfinedProcess.start(
        confinement.command(),
        confinement,
        confinement.environment(),
        ControlGroup.NONE,
        0,
        () -> {});
  }
}
