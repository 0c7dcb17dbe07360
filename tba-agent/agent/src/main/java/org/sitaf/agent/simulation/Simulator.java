package org.sitaf.agent.simulation;

import java.nio.file.Path;
import java.util.List;

/**
 * A robot simulator that test applications of this machine can reach. Safe to use from several
 * threads.
 */
public sealed interface Simulator extends AutoCloseable
    permits StartedSimulator, RunningSimulator, NoSimulator {

  /**
   * A gRPC target at which a simulator answers now. One of the agent's own is started when it does
   * not run yet or has died.
   *
   * @throws SimulatorException when none answers and none can be started
   */
  String target() throws SimulatorException, InterruptedException;

  @Override
  void close();

  /**
   * A bridge of one's own: started when it is first needed, kept for the next builds, ended with
   * this object.
   *
   * @param command what starts {@code sitaf_bridge}, such as {@code python -m sitaf_bridge}; its
   *     arguments are appended
   * @param directory private to the caller; holds the socket and the bridge's log
   */
  static Simulator started(List<String> command, Path directory) {
    return new StartedSimulator(command, directory);
  }

  /** One that somebody else runs at this gRPC target. */
  static Simulator running(String target) {
    return new RunningSimulator(target);
  }

  /** None; activities with a world cannot be tested. */
  static Simulator none() {
    return new NoSimulator();
  }
}
