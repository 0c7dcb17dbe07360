package org.sitaf.agent.simulation;

import java.util.Map;

/**
 * The robot simulator as one build has it, until it is closed. Safe to use from several threads.
 */
public sealed interface BuildSimulator extends AutoCloseable permits OwnSimulator, SharedSimulator {

  /** Whose it is and what bounds it, for the build's log. */
  String description();

  /**
   * Name and version, such as {@code sitaf-bridge 0.1.0 (MuJoCo 4.0.0)}.
   *
   * @throws SimulatorException when it does not answer
   */
  String version() throws SimulatorException, InterruptedException;

  /**
   * Lets the simulator compile the build's world, the only one that its endpoints offer.
   *
   * @param description name of the world description among the files
   * @param files of the world's folder, by relative path
   * @throws WorldException when the simulator refuses it, or does not survive it
   * @throws SimulatorException when it does not answer
   */
  void check(String description, Map<String, byte[]> files)
      throws WorldException, SimulatorException, InterruptedException;

  /**
   * Opens what one process of a test application reaches; {@link #check} comes before.
   *
   * @throws SimulatorException when no simulator answers and none can be started
   */
  SimulatorEndpoint open() throws SimulatorException, InterruptedException;

  /**
   * A gRPC target that offers everything; no test application is given it.
   *
   * @throws SimulatorException when no simulator answers and none can be started
   */
  String target() throws SimulatorException, InterruptedException;

  @Override
  void close();
}
