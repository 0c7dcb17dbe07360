package org.sitaf.core.explain;

import java.util.List;
import java.util.Set;

/**
 * The causes of the failures of a suite.
 *
 * @param found minimal tuples that fail with any other values
 * @param executions number of executed rows beyond the suite
 * @param unexplained indices of the failing rows of the suite that have no cause
 */
public record Causes(List<Found> found, int executions, Set<Integer> unexplained) {
  public Causes {
    found = List.copyOf(found);
    unexplained = Set.copyOf(unexplained);
  }

  /**
   * A cause.
   *
   * @param executions needed to find and confirm it
   */
  public record Found(Tuple tuple, int executions) {}

  /**
   * Searches the causes of all failing rows.
   *
   * @param budget maximum number of executions
   * @param seed of the choice of rows
   * @throws InterruptedException if the search is cancelled
   */
  public static Causes find(
      Combinations combinations, Combinations.Execution execution, int budget, long seed)
      throws InterruptedException {
    History history = new History(combinations, execution, budget);
    TupleSearch search = new TupleSearch(history, null, seed);
    search.search();
    return new Causes(
        search.causes().stream().map(c -> new Found(c, search.executionsOf(c))).toList(),
        history.executions(),
        search.unexplainedOfSuite());
  }
}
