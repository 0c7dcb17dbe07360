package org.sitaf.core.combine;

import java.util.Arrays;
import java.util.List;

/**
 * Rows that cover all tuples of a {@link CombinationProblem}.
 *
 * @param rows the seeds in their order, then the new rows in ascending order; one value per
 *     parameter
 * @param tuples number of covered and impossible tuples
 * @param optimal whether it is proven that no smaller array exists
 * @param rejectedSeeds indices of seeds that violate the constraints and are not in the rows
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record CoveringArray(
    int[][] rows, TupleReport tuples, boolean optimal, List<Integer> rejectedSeeds) {
  public CoveringArray {
    rows = copy(rows);
    rejectedSeeds = List.copyOf(rejectedSeeds);
  }

  @Override
  public int[][] rows() {
    return copy(rows);
  }

  /** The number of rows. */
  public int size() {
    return rows.length;
  }

  private static int[][] copy(int[][] rows) {
    return Arrays.stream(rows).map(int[]::clone).toArray(int[][]::new);
  }

  /**
   * Counts the required tuples. Parameters with a single value are ignored, and a tuple that is
   * part of a larger required tuple is not counted.
   *
   * @param covered number of covered tuples: all possible ones
   * @param impossible number of tuples that the constraints exclude
   * @param examples the first impossible tuples, at most {@link #MAX_EXAMPLES}
   */
  public record TupleReport(long covered, long impossible, List<Tuple> examples) {
    /** Maximum number of listed impossible tuples. */
    public static final int MAX_EXAMPLES = 1000;

    public TupleReport {
      examples = List.copyOf(examples);
    }
  }

  /**
   * A combination of values.
   *
   * @param parameters indices in ascending order
   * @param values one value per parameter
   */
  @SuppressWarnings("ArrayRecordComponent") // copied in and out
  public record Tuple(int[] parameters, int[] values) {
    public Tuple {
      parameters = parameters.clone();
      values = values.clone();
    }

    @Override
    public int[] parameters() {
      return parameters.clone();
    }

    @Override
    public int[] values() {
      return values.clone();
    }

    @Override
    public String toString() {
      return Arrays.toString(parameters) + "=" + Arrays.toString(values);
    }
  }
}
