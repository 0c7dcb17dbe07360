package org.sitaf.core.compare;

import java.util.List;
import java.util.Objects;

/**
 * Differences that have kind, output and change in common.
 *
 * @param text what changed, and for which values of the inputs
 * @param differences at least one, in the order of models and cases
 */
public record DifferenceGroup(
    String text, DifferenceClass kind, String output, List<Difference> differences) {
  public DifferenceGroup {
    Objects.requireNonNull(text);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(output);
    differences = List.copyOf(differences);
    if (differences.isEmpty()) {
      throw new IllegalArgumentException("a group needs a difference");
    }
  }
}
