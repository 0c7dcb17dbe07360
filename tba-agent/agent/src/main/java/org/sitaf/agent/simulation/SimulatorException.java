package org.sitaf.agent.simulation;

import java.io.IOException;

/** The simulator does not answer. Never the fault of a test. */
public final class SimulatorException extends IOException {
  private static final long serialVersionUID = 1L;

  public SimulatorException(String message) {
    super(message);
  }

  SimulatorException(String message, Throwable cause) {
    super(message, cause);
  }
}
