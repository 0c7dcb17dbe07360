package org.sitaf.agent.simulation;

/** The simulator rejects a world. The message is the simulator's; a retry gives the same result. */
public final class WorldException extends Exception {
  private static final long serialVersionUID = 1L;

  WorldException(String message) {
    super(message);
  }
}
