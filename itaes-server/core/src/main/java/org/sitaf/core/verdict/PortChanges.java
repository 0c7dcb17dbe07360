package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;

/**
 * The values of an output data port of the component in a case, or of a part of it.
 *
 * @param signal name of the port or of the part
 * @param changes in the order of their times
 * @param leftOut number of further changes that were not recorded
 */
public record PortChanges(String signal, List<Change> changes, long leftOut) {
  public PortChanges {
    Objects.requireNonNull(signal);
    changes = List.copyOf(changes);
    if (leftOut < 0) {
      throw new IllegalArgumentException("left_out must be at least 0, not " + leftOut);
    }
  }

  /**
   * A new value.
   *
   * @param nanos simulation time since the call, negative before it
   */
  public record Change(long nanos, String literal) {
    public Change {
      Objects.requireNonNull(literal);
    }
  }
}
