package org.sitaf.agent.simulation;

/** No simulator was configured. */
record NoSimulator() implements Simulator {
  @Override
  public BuildSimulator forBuild() throws SimulatorException {
    throw new SimulatorException(
        "the activity has a world, but no simulator is configured; start the agent with"
            + " --bridge-command or --bridge");
  }

  @Override
  public void close() {}
}
