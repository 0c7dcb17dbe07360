package org.sitaf.core.compare;

import java.util.List;

/**
 * The comparison of two versions.
 *
 * @param cases those that both versions executed
 * @param differences confirmed ones, in the order of models and cases
 * @param lastBits numbers that differ in their last bits or in the sign of a zero only
 * @param unstable differences that are not the same in all runs of a version
 * @param slower cases that take longer, with the medians of both versions in microseconds
 */
public record Comparison(
    List<ComparedCase> cases,
    List<Difference> differences,
    List<Difference> lastBits,
    List<Difference> unstable,
    List<Difference> slower,
    List<NotComparable> notComparable) {
  public Comparison {
    cases = List.copyOf(cases);
    differences = List.copyOf(differences);
    lastBits = List.copyOf(lastBits);
    unstable = List.copyOf(unstable);
    slower = List.copyOf(slower);
    notComparable = List.copyOf(notComparable);
  }

  /** The groups of the differences, the largest last. */
  public List<DifferenceGroup> groups() {
    return DifferenceGroups.of(differences, cases);
  }
}
