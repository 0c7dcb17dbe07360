package org.sitaf.runtime.simulation;

/** A call to the simulator failed. */
public final class SimulationException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean lost;

  SimulationException(String message, boolean lost, Throwable cause) {
    super(message, cause);
    this.lost = lost;
  }

  SimulationException(String message) {
    super(message);
    this.lost = false;
  }

  /**
   * Whether the simulator or the session is lost, so that no further case can run. Otherwise the
   * simulator rejected one request, and the next may succeed.
   */
  public boolean isLost() {
    return lost;
  }
}
