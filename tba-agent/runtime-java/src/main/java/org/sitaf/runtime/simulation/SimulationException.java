package org.sitaf.runtime.simulation;

/** The simulator did not do what it was asked to. */
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
   * Whether the simulator or the session is gone, so that no further case can run; otherwise it
   * refused one request, and the next may succeed.
   */
  public boolean isLost() {
    return lost;
  }
}
