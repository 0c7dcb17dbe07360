package org.sitaf.core.combine;

import java.util.Arrays;
import java.util.List;

/**
 * Rows that cover what a {@link CombinationProblem} asks for.
 *
 * @param rows the seeds in their order, then the new rows in ascending order; each holds a value
 *     for every parameter
 * @param tuples what was covered, and what cannot be
 * @param optimal whether no smaller array exists, by proof
 * @param refusedSeeds indices of the seeds that no allowed row holds, and that are left out of the
 *     rows
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out
public record CoveringArray(
    int[][] rows, TupleReport tuples, boolean optimal, List<Integer> refusedSeeds) {
  public CoveringArray {
    rows = copy(rows);
    refusedSeeds = List.copyOf(refusedSeeds);
  }

  @Override
  public int[][] rows() {
    return copy(rows);
  }

  /** How many rows there are. */
  public int size() {
    return rows.length;
  }

  private static int[][] copy(int[][] rows) {
    return Arrays.stream(rows).map(int[]::clone).toArray(int[][]::new);
  }

  /**
   * The tuples that the interactions ask for. Parameters with a single value take no part, and a
   * tuple that a larger one implies is not counted beside it.
   *
   * @param covered how many the rows cover: all that are possible
   * @param impossible how many no allowed row can hold
   * @param examples the first of the impossible ones, at most {@link #MAX_EXAMPLES}
   */
  public record TupleReport(long covered, long impossible, List<Tuple> examples) {
    /** How many impossible tuples are listed. */
    public static final int MAX_EXAMPLES = 1000;

    public TupleReport {
      examples = List.copyOf(examples);
    }
  }

  /**
   * Values that should stand together in a row.
   *
   * @param parameters indices in ascending order
   * @param values one for each of them
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
