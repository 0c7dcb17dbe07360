package org.sitaf.agent.simulation;

/**
 * The simulator refuses a world; the message is the simulator's, and trying again gives the same.
 */
public final class WorldException extends Exception {
  private static final long serialVersionUID = 1L;

  WorldException(String message) {
    super(message);
  }
}
