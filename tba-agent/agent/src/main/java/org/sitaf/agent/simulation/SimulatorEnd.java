package org.sitaf.agent.simulation;

import java.util.Objects;

/**
 * How a simulator ended.
 *
 * @param reason for a person
 * @param byLimit whether it used more than it may, which its world or its component made it do
 */
public record SimulatorEnd(String reason, boolean byLimit) {
  public SimulatorEnd {
    Objects.requireNonNull(reason);
  }
}
