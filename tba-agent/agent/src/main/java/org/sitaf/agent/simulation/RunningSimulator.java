package org.sitaf.agent.simulation;

import java.util.Objects;

/** A simulator that is not managed by the agent. */
record RunningSimulator(String target) implements Simulator {
  RunningSimulator {
    Objects.requireNonNull(target);
  }

  @Override
  public BuildSimulator forBuild() {
    return new SharedSimulator(target);
  }

  @Override
  public void close() {}
}
