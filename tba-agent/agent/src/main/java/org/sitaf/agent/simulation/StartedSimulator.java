package org.sitaf.agent.simulation;

import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A bridge process of the agent's own, kept warm. */
final class StartedSimulator implements Simulator {
  private final List<String> command;
  private final Path directory;
  private @Nullable BridgeProcess bridge;
  private boolean closed;

  StartedSimulator(List<String> command, Path directory) {
    if (command.isEmpty()) {
      throw new IllegalArgumentException("the bridge's command is empty");
    }
    this.command = List.copyOf(command);
    this.directory = directory;
  }

  @Override
  public synchronized String target() throws SimulatorException, InterruptedException {
    if (closed) {
      throw new SimulatorException("the simulator was ended");
    }
    if (bridge == null || !bridge.isAlive()) {
      if (bridge != null) {
        bridge.close();
      }
      // A socket of its own for each process: a changed target tells that the simulator is another
      // one.
      bridge = BridgeProcess.start(command, directory);
    }
    return bridge.target();
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (bridge != null) {
      bridge.close();
      bridge = null;
    }
  }
}
