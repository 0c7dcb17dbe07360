package org.sitaf.core.combine.coverage;

/**
 * Numbers all values of all columns consecutively. A row is then a set of symbols, stored in a few
 * machine words.
 */
public final class Symbols {
  private static final int MAX_IN_SETS = 6000;

  final int[] levels;
  private final int[] offset;
  private final int[] columnOf;

  /** Creates the symbols for columns with the given numbers of values. */
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

  /** The number of columns. */
  public int columns() {
    return levels.length;
  }

  /** The number of values of a column. */
  public int levels(int column) {
    return levels[column];
  }

  /** The number of values of each column. */
  public int[] levels() {
    return levels.clone();
  }

  /** The number of symbols. */
  public int count() {
    return offset[levels.length];
  }

  /** Whether rows store bit sets of their symbols; too much memory if there are many symbols. */
  public boolean hasSets() {
    return count() <= MAX_IN_SETS;
  }

  /** The number of 64-bit words of a bit set. */
  public int words() {
    return (count() + 63) >>> 6;
  }

  /** The symbol of a value of a column. */
  public int symbol(int column, int value) {
    return offset[column] + value;
  }

  /** The first symbol of a column; the number of symbols for the column after the last. */
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
