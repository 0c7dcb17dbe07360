package org.sitaf.core.combine;

import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * Rows that cover as many tuples as fit, in the order in which they were chosen.
 *
 * @param rows one value per parameter; the seeds first
 * @param needed the first rows that are necessary for the seeds and for each value
 * @param covered number of covered tuples after each row
 * @param tuples number of all possible and of impossible tuples
 * @param rejectedSeeds indices of seeds that violate the constraints and are not in the rows
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record GrownArray(
    int[][] rows,
    int needed,
    long[] covered,
    CoveringArray.TupleReport tuples,
    List<Integer> rejectedSeeds) {
  public GrownArray {
    rows = Arrays.stream(rows).map(int[]::clone).toArray(int[][]::new);
    covered = covered.clone();
    rejectedSeeds = List.copyOf(rejectedSeeds);
  }

  @Override
  public int[][] rows() {
    return Arrays.stream(rows).map(int[]::clone).toArray(int[][]::new);
  }

  @Override
  public long[] covered() {
    return covered.clone();
  }

  /** A pair of parameters; {@code first} is the smaller index. */
  public record Pair(int first, int second) {}

  /**
   * Tuples that hold both parameters of a pair.
   *
   * @param lost number of possible tuples that are not covered
   * @param all number of possible tuples
   */
  public record Loss(long lost, long all) {}

  /** The losses of all pairs that lost a tuple. */
  public record Losses(Map<Pair, Loss> byPair) {
    public Losses {
      byPair = Map.copyOf(byPair);
    }
  }
}
