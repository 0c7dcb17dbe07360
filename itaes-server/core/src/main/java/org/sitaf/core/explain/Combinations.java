package org.sitaf.core.explain;

import java.util.List;
import java.util.Objects;
import java.util.function.BiPredicate;
import java.util.function.Predicate;

/**
 * The combinations of values in which causes are searched.
 *
 * @param levels number of values of each parameter
 * @param executed the rows of the suite, with their outcomes
 * @param allowed whether a row may be executed; a pure function
 * @param invalid whether a value of a parameter is invalid. An invalid value hides other causes: a
 *     row that passes with it says something only about tuples that contain it
 * @param strength order of the combinations that the suite covers, from 1
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record Combinations(
    int[] levels,
    List<Row> executed,
    Predicate<int[]> allowed,
    BiPredicate<Integer, Integer> invalid,
    int strength) {
  public Combinations {
    levels = levels.clone();
    executed = List.copyOf(executed);
    Objects.requireNonNull(allowed);
  }

  /** Combinations without invalid values. */
  public Combinations(int[] levels, List<Row> executed, Predicate<int[]> allowed, int strength) {
    this(levels, executed, allowed, (parameter, level) -> false, strength);
  }

  /** The parameters with an invalid value, one bit for each. */
  long invalidOf(int[] row) {
    long mask = 0;
    for (int i = 0; i < row.length; i++) {
      if (invalid.test(i, row[i])) {
        mask |= 1L << i;
      }
    }
    return mask;
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
