package org.sitaf.agent.simulation;

import java.util.List;

/**
 * The signals that a simulator samples at each step of a build.
 *
 * @param names of the signals
 * @param settling whether also while the world settles before the call
 */
public record SignalOrder(List<String> names, boolean settling) {
  public SignalOrder {
    names = List.copyOf(names);
  }
}
