package org.sitaf.core.compare;

import java.util.List;

/**
 * How two executions of a case differ.
 *
 * @param differences those that are more than the last bits
 * @param lastBits numbers that differ in the last bits only
 * @param notComparable what only one of them has
 */
public record CaseDifferences(
    List<Difference> differences, List<Difference> lastBits, List<NotComparable> notComparable) {
  public CaseDifferences {
    differences = List.copyOf(differences);
    lastBits = List.copyOf(lastBits);
    notComparable = List.copyOf(notComparable);
  }

  /** Whether the case was executed by both versions. */
  public boolean isCompared() {
    return notComparable.stream().noneMatch(n -> n.no() > 0 && n.output().isEmpty());
  }
}
