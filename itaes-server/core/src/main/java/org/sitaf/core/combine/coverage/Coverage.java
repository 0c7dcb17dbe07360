package org.sitaf.core.combine.coverage;

import org.sitaf.core.combine.SeededRandom;

/**
 * Counts how often each required tuple occurs in the added rows. Impossible tuples are excluded
 * before the first row is added.
 */
public interface Coverage {
  /** The number of required tuples. */
  long required();

  /** The number of uncovered tuples. */
  int uncovered();

  /**
   * The number of uncovered tuples that consist of this value and other cells of the row. The
   * current value of the column is ignored; tuples with free cells are not counted.
   */
  int gain(Row row, int column, int value);

  /** The number of tuples with this cell that only this row covers. */
  int loss(Row row, int column);

  /** Sets {@code out[v]} to {@link #gain} for each value {@code v} of the column. */
  void gains(Row row, int column, int[] out);

  /** Adds a complete row. */
  void add(Row row);

  /** Removes an added row. */
  void remove(Row row);

  /** Changes one cell of an added row and updates the counts. */
  void change(Row row, int column, int value);

  /** Selects a random uncovered tuple; there must be at least one. */
  Tuple pick(SeededRandom random);

  /**
   * Makes a tuple no longer required.
   *
   * @param columns columns in ascending order
   * @param values one value per column
   */
  void exclude(int[] columns, int[] values);

  /** The cost of {@link #gain} or {@link #loss} in operations of about 1 ns. */
  int cost();

  /** The cost of {@link #gains} in operations. */
  default int gainsCost(int levels) {
    return levels * cost();
  }

  /** The cost of {@link #change} in operations. */
  int changeCost();

  /**
   * A combination of values.
   *
   * @param columns columns in ascending order
   * @param values one value per column
   */
  @SuppressWarnings("ArrayRecordComponent") // a new instance for each pick
  record Tuple(int[] columns, int[] values) {}
}
