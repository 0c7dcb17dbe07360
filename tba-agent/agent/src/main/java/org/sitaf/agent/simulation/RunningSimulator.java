package org.sitaf.agent.simulation;

import java.util.Objects;

/** A simulator that somebody else runs. */
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
