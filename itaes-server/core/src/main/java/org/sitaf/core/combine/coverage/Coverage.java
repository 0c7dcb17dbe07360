package org.sitaf.core.combine.coverage;

/**
 * How often each required tuple occurs in the rows added so far. Tuples are required from the
 * start; those that are impossible are excluded before the first row is added.
 */
public interface Coverage {
  /** Required tuples. */
  long required();

  /** Required tuples that no row covers. */
  int uncovered();

  /**
   * How many uncovered tuples would be covered that hold this value and otherwise cells of this
   * row. The row's own cell in this column does not matter, and free cells cover nothing.
   */
  int gain(Row row, int column, int value);

  /** How many tuples only this row covers and which hold its cell of this column. */
  int loss(Row row, int column);

  /** Fills {@code out[v]} with {@link #gain} for every value {@code v} of the column. */
  void gains(Row row, int column, int[] out);

  /** Counts a complete row. */
  void add(Row row);

  /** Takes back a complete row that was counted. */
  void remove(Row row);

  /** Changes one cell of a counted row, in the row and in the counts. */
  void change(Row row, int column, int value);

  /** Finds an uncovered tuple, by chance; there must be one. */
  Tuple pick(Dice dice);

  /**
   * Requires this tuple no longer, if it was required.
   *
   * @param columns in ascending order
   * @param values one for each column
   */
  void exclude(int[] columns, int[] values);

  /** What one call of {@link #gain} or {@link #loss} costs, in operations of about 1 ns. */
  int cost();

  /** What one call of {@link #gains} costs, in the same operations. */
  default int gainsCost(int levels) {
    return levels * cost();
  }

  /** What one {@link #change} costs, in the same operations. */
  int changeCost();

  /**
   * Values that stand together.
   *
   * @param columns in ascending order
   * @param values one for each column
   */
  @SuppressWarnings("ArrayRecordComponent") // made anew for each pick
  record Tuple(int[] columns, int[] values) {}
}
