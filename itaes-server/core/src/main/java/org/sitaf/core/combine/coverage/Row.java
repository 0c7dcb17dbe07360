package org.sitaf.core.combine.coverage;

import java.util.Arrays;

/** A row of values, some of which may be free. Also available as a set of symbols. */
public final class Row {
  /** The value is not chosen yet. */
  public static final int FREE = -1;

  final int[] values;
  final int[] chosen;

  /** The set of symbols; empty if there are too many symbols for bit sets. */
  final long[] bits;

  private final boolean[] fixed;
  private final long[] touched;
  private final Symbols symbols;
  private boolean kept;

  /** Creates a row of free cells. */
  public Row(Symbols symbols) {
    this.symbols = symbols;
    this.values = new int[symbols.columns()];
    this.chosen = new int[symbols.columns()];
    this.bits = new long[symbols.hasSets() ? symbols.words() : 0];
    this.fixed = new boolean[symbols.columns()];
    this.touched = new long[symbols.columns()];
    Arrays.fill(values, FREE);
    Arrays.fill(chosen, FREE);
  }

  /** Creates a row of values. */
  public Row(Symbols symbols, int[] values) {
    this(symbols);
    for (int c = 0; c < values.length; c++) {
      set(c, values[c]);
    }
  }

  /** The value of a column, or {@link #FREE}. */
  public int value(int column) {
    return values[column];
  }

  /** A copy of the values. */
  public int[] values() {
    return values.clone();
  }

  /**
   * Changes one cell. A row that was added to a {@link Coverage} must be changed by {@link
   * Coverage#change}.
   */
  public void set(int column, int value) {
    int old = chosen[column];
    if (old >= 0 && bits.length > 0) {
      bits[old >>> 6] &= ~(1L << old);
    }
    values[column] = value;
    if (value == FREE) {
      chosen[column] = FREE;
    } else {
      int symbol = symbols.symbol(column, value);
      chosen[column] = symbol;
      if (bits.length > 0) {
        bits[symbol >>> 6] |= 1L << symbol;
      }
    }
  }

  /** Keeps this row in the array, and its cells that are chosen in {@code seed}. */
  public void keep(int[] seed) {
    kept = true;
    for (int c = 0; c < values.length; c++) {
      fixed[c] = seed[c] != FREE;
    }
  }

  /** Whether this row must not be removed. */
  public boolean kept() {
    return kept;
  }

  /** Whether a cell must not be changed. */
  public boolean fixed(int column) {
    return fixed[column];
  }

  /** The search step of the last change of a cell. */
  public long touched(int column) {
    return touched[column];
  }

  /** Records the search step of a change. */
  public void touch(int column, long step) {
    touched[column] = step;
  }
}
