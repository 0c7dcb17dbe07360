package org.sitaf.core.explain;

import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;

/**
 * The combinations of values in which causes are searched.
 *
 * @param levels number of values of each parameter
 * @param executed the rows of the suite, with their outcomes
 * @param allowed whether a row may be executed; a pure function
 * @param strength order of the combinations that the suite covers, from 1
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record Combinations(
    int[] levels, List<Row> executed, Predicate<int[]> allowed, int strength) {
  public Combinations {
    levels = levels.clone();
    executed = List.copyOf(executed);
    Objects.requireNonNull(allowed);
  }

  @Override
  public int[] levels() {
    return levels.clone();
  }

  /**
   * An executed row.
   *
   * @param values index of the value of each parameter
   */
  @SuppressWarnings("ArrayRecordComponent") // not changed after creation
  public record Row(int[] values, Outcome outcome) {}

  /** Executes rows that the suite does not contain. */
  @FunctionalInterface
  public interface Execution {
    /**
     * Executes a row.
     *
     * @throws InterruptedException if the search is cancelled
     */
    Outcome execute(int[] row) throws InterruptedException;
  }
}
