package org.sitaf.core.combine.coverage;

import java.util.Arrays;

/** A row of values, some perhaps not yet chosen, which is also a set of symbols. */
public final class Row {
  /** No value chosen yet. */
  public static final int FREE = -1;

  final int[] values;
  final int[] chosen;

  /** The set of its symbols; empty where there are too many symbols for sets of them. */
  final long[] bits;

  private final boolean[] fixed;
  private final long[] touched;
  private final Symbols symbols;
  private boolean kept;

  /** A row without any value. */
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

  /** A row of these values. */
  public Row(Symbols symbols, int[] values) {
    this(symbols);
    for (int c = 0; c < values.length; c++) {
      set(c, values[c]);
    }
  }

  /** The value of this column, or {@link #FREE}. */
  public int value(int column) {
    return values[column];
  }

  /** A copy of the values. */
  public int[] values() {
    return values.clone();
  }

  /** Changes one cell; rows that a {@link Coverage} counts are changed through it. */
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

  /** Keeps this row in the array, with the cells that are chosen in {@code seed} as they are. */
  public void keep(int[] seed) {
    kept = true;
    for (int c = 0; c < values.length; c++) {
      fixed[c] = seed[c] != FREE;
    }
  }

  /** Whether this row must stay. */
  public boolean kept() {
    return kept;
  }

  /** Whether this cell must stay. */
  public boolean fixed(int column) {
    return fixed[column];
  }

  /** The step at which a search last changed this cell. */
  public long touched(int column) {
    return touched[column];
  }

  /** Notes the step at which a search changed this cell. */
  public void touch(int column, long step) {
    touched[column] = step;
  }
}
