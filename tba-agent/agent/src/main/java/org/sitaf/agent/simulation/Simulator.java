package org.sitaf.agent.simulation;

import java.nio.file.Path;
import java.util.List;
import org.sitaf.agent.sandbox.Sandbox;

/** Provides the builds of this machine with robot simulators. Thread-safe. */
public sealed interface Simulator extends AutoCloseable
    permits BridgePool, RunningSimulator, NoSimulator {

  /** Number of builds of an agent, which does not know how many follow. */
  int UNLIMITED = Integer.MAX_VALUE;

  /**
   * The simulator of one build.
   *
   * @throws SimulatorException if there is none and none can be started
   */
  BuildSimulator forBuild() throws SimulatorException, InterruptedException;

  @Override
  void close();

  /**
   * A new bridge for each build. The bridge of the next build is started ahead; each bridge ends
   * with its build.
   *
   * @param command starts {@code sitaf_bridge}, such as {@code python -m sitaf_bridge}; its
   *     arguments are appended
   * @param directory private to the caller; holds the bridges' folders
   * @param sandbox in which the bridges run
   * @param builds number of expected builds: at most that many bridges are started ahead
   */
  static Simulator started(List<String> command, Path directory, Sandbox sandbox, int builds) {
    return new BridgePool(command, directory, sandbox, builds);
  }

  /** An existing simulator at this gRPC target, shared with others. */
  static Simulator running(String target) {
    return new RunningSimulator(target);
  }

  /** No simulator; activities with a world cannot be tested. */
  static Simulator none() {
    return new NoSimulator();
  }
}
