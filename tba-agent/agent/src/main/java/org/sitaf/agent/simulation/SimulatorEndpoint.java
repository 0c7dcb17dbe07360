package org.sitaf.agent.simulation;

import java.util.Optional;

/** The access of one process of a test application to a simulator. */
public interface SimulatorEndpoint extends AutoCloseable {
  /** A gRPC target. */
  String target();

  /** Whether other users' builds share the simulator, so that its state is unknown here. */
  boolean isShared();

  /** Whether the simulator's process has ended; makes no call. */
  boolean hasEnded();

  /** Calls the simulator; returns why it does not answer, or empty if it does. */
  Optional<SimulatorEnd> end() throws InterruptedException;

  /** Stops real devices safely, because the test application has ended. */
  default void stopDevices() {
    // All devices are simulated.
  }

  /** Closes the session. A simulator that does not stop the session's calls is killed. */
  @Override
  void close();
}
