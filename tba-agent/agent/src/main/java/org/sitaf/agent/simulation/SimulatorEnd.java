package org.sitaf.agent.simulation;

import java.util.Objects;

/**
 * How a simulator ended.
 *
 * @param reason text for the log
 * @param byLimit whether it exceeded a limit, because of its world or the component's calls
 */
public record SimulatorEnd(String reason, boolean byLimit) {
  public SimulatorEnd {
    Objects.requireNonNull(reason);
  }
}
