package org.sitaf.agent.simulation;

import java.nio.file.Path;
import java.util.List;
import org.sitaf.agent.sandbox.Sandbox;

/**
 * Where the builds of this machine get their robot simulators. Safe to use from several threads.
 */
public sealed interface Simulator extends AutoCloseable
    permits StartedSimulator, RunningSimulator, NoSimulator {

  /** How many builds an agent expects. */
  int ALWAYS = Integer.MAX_VALUE;

  /**
   * The simulator of one build.
   *
   * @throws SimulatorException when there is none and none can be started
   */
  BuildSimulator forBuild() throws SimulatorException, InterruptedException;

  /** Waits until the simulator of the next build is started, where one is started ahead. */
  default void awaitReady() throws InterruptedException {}

  @Override
  void close();

  /**
   * A bridge for each build: one that no build has used waits for the next, and each ends with its
   * build.
   *
   * @param command what starts {@code sitaf_bridge}, such as {@code python -m sitaf_bridge}; its
   *     arguments are appended
   * @param directory private to the caller; holds the bridges' folders
   * @param sandbox in which the bridges run
   * @param builds how many are expected: no more bridges than that are started ahead
   */
  static Simulator started(List<String> command, Path directory, Sandbox sandbox, int builds) {
    return new StartedSimulator(command, directory, sandbox, builds);
  }

  /** One that somebody else runs at this gRPC target, and that is shared with others. */
  static Simulator running(String target) {
    return new RunningSimulator(target);
  }

  /** None; activities with a world cannot be tested. */
  static Simulator none() {
    return new NoSimulator();
  }
}
