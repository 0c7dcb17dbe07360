package org.sitaf.core.combine.coverage;

/**
 * Numbers all values of all columns densely, column by column, so that a row is a set of symbols
 * and a set of symbols is a few machine words.
 */
public final class Symbols {
  private static final int MAX_IN_SETS = 6000;

  final int[] levels;
  private final int[] offset;
  private final int[] columnOf;

  /** Symbols of columns with these numbers of values. */
  public Symbols(int... levels) {
    this.levels = levels.clone();
    this.offset = new int[levels.length + 1];
    for (int c = 0; c < levels.length; c++) {
      offset[c + 1] = offset[c] + levels[c];
    }
    this.columnOf = new int[count()];
    for (int c = 0; c < levels.length; c++) {
      java.util.Arrays.fill(columnOf, offset[c], offset[c + 1], c);
    }
  }

  /** How many columns there are. */
  public int columns() {
    return levels.length;
  }

  /** How many values this column has. */
  public int levels(int column) {
    return levels[column];
  }

  /** A copy of all numbers of values. */
  public int[] levels() {
    return levels.clone();
  }

  /** How many symbols there are. */
  public int count() {
    return offset[levels.length];
  }

  /** Whether a row may hold the set of its symbols: with more, a row for each would be too much. */
  public boolean hasSets() {
    return count() <= MAX_IN_SETS;
  }

  /** Words of 64 bits that a set of symbols takes. */
  public int words() {
    return (count() + 63) >>> 6;
  }

  /** The symbol of this value of this column. */
  public int symbol(int column, int value) {
    return offset[column] + value;
  }

  /** The first symbol of a column; of the column after the last, the number of symbols. */
  public int first(int column) {
    return offset[column];
  }

  /** The column of a symbol. */
  public int column(int symbol) {
    return columnOf[symbol];
  }

  /** The value of a symbol in its column. */
  public int value(int symbol) {
    return symbol - offset[columnOf[symbol]];
  }
}
