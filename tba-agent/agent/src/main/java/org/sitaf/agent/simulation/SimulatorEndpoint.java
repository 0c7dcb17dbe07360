package org.sitaf.agent.simulation;

import java.util.Optional;

/** What one process of a test application reaches of a simulator. */
public interface SimulatorEndpoint extends AutoCloseable {
  /** A gRPC target. */
  String target();

  /** Whether builds of others use the same simulator, so that nobody here knows how it fares. */
  boolean isShared();

  /** Whether the simulator's process has ended; does not ask it anything. */
  boolean hasEnded();

  /** Asks the simulator whether it still answers; why it does not, or empty. */
  Optional<SimulatorEnd> end() throws InterruptedException;

  /** Frees the session. A simulator that cannot stop what it was asked to do ends with it. */
  @Override
  void close();
}
