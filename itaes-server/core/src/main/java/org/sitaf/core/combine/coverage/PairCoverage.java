package org.sitaf.core.combine.coverage;

import java.util.List;

/**
 * Coverage of pairs. A symmetric matrix of counts, and for each symbol the set of partners with
 * which it is uncovered, and the set with which it is covered once: a gain or a loss is a handful
 * of bit counts.
 */
final class PairCoverage implements Coverage {
  /** A count that never comes back to one: this pair is not required. */
  private static final int NOT_REQUIRED = 1 << 29;

  private final Symbols symbols;
  private final int size;
  private final int words;
  private final int[] counts;
  private final long[] never;
  private final long[] once;
  private final int[] open;
  private long required;
  private int uncovered;

  PairCoverage(Symbols symbols, List<int[]> columnPairs) {
    this.symbols = symbols;
    this.size = symbols.count();
    this.words = symbols.words();
    this.counts = new int[size * size];
    this.never = new long[size * words];
    this.once = new long[size * words];
    this.open = new int[size];
    java.util.Arrays.fill(counts, NOT_REQUIRED);
    for (int[] pair : columnPairs) {
      for (int a = symbols.first(pair[0]); a < symbols.first(pair[0] + 1); a++) {
        for (int b = symbols.first(pair[1]); b < symbols.first(pair[1] + 1); b++) {
          counts[a * size + b] = 0;
          counts[b * size + a] = 0;
          flip(never, a, b);
          open[a]++;
          open[b]++;
          uncovered++;
        }
      }
    }
    required = uncovered;
  }

  private void flip(long[] set, int a, int b) {
    set[a * words + (b >>> 6)] ^= 1L << b;
    set[b * words + (a >>> 6)] ^= 1L << a;
  }

  @Override
  public long required() {
    return required;
  }

  @Override
  public int uncovered() {
    return uncovered;
  }

  @Override
  public int gain(Row row, int column, int value) {
    return common(never, symbols.symbol(column, value), row.bits);
  }

  @Override
  public int loss(Row row, int column) {
    return common(once, row.chosen[column], row.bits);
  }

  private int common(long[] set, int symbol, long[] bits) {
    int sum = 0;
    int base = symbol * words;
    for (int w = 0; w < words; w++) {
      sum += Long.bitCount(set[base + w] & bits[w]);
    }
    return sum;
  }

  @Override
  public void gains(Row row, int column, int[] out) {
    for (int v = 0; v < symbols.levels(column); v++) {
      out[v] = gain(row, column, v);
    }
  }

  @Override
  public void add(Row row) {
    int columns = symbols.columns();
    for (int c = 0; c < columns; c++) {
      for (int d = c + 1; d < columns; d++) {
        increment(row.chosen[c], row.chosen[d]);
      }
    }
  }

  @Override
  public void remove(Row row) {
    int columns = symbols.columns();
    for (int c = 0; c < columns; c++) {
      for (int d = c + 1; d < columns; d++) {
        decrement(row.chosen[c], row.chosen[d]);
      }
    }
  }

  @Override
  public void change(Row row, int column, int value) {
    int before = row.chosen[column];
    int after = symbols.symbol(column, value);
    for (int d = 0; d < row.chosen.length; d++) {
      if (d != column) {
        decrement(before, row.chosen[d]);
        increment(after, row.chosen[d]);
      }
    }
    row.set(column, value);
  }

  private void increment(int a, int b) {
    counts[b * size + a]++;
    int n = ++counts[a * size + b];
    if (n == 1) {
      flip(never, a, b);
      flip(once, a, b);
      open[a]--;
      open[b]--;
      uncovered--;
    } else if (n == 2) {
      flip(once, a, b);
    }
  }

  private void decrement(int a, int b) {
    counts[b * size + a]--;
    int n = --counts[a * size + b];
    if (n == 0) {
      flip(never, a, b);
      flip(once, a, b);
      open[a]++;
      open[b]++;
      uncovered++;
    } else if (n == 1) {
      flip(once, a, b);
    }
  }

  @Override
  public Tuple pick(Dice dice) {
    int left = dice.below(2 * uncovered);
    int a = 0;
    while (left >= open[a]) {
      left -= open[a++];
    }
    int b = nth(never, a * words, left);
    int first = Math.min(a, b);
    int second = Math.max(a, b);
    return new Tuple(
        new int[] {symbols.column(first), symbols.column(second)},
        new int[] {symbols.value(first), symbols.value(second)});
  }

  /** The {@code n}-th member (from 0) of the set whose words start at {@code base}. */
  static int nth(long[] set, int base, int n) {
    int left = n;
    int w = base;
    while (left >= Long.bitCount(set[w])) {
      left -= Long.bitCount(set[w++]);
    }
    long word = set[w];
    while (left-- > 0) {
      word &= word - 1;
    }
    return ((w - base) << 6) + Long.numberOfTrailingZeros(word);
  }

  @Override
  public void exclude(int[] columns, int[] values) {
    if (columns.length != 2) {
      return;
    }
    int a = symbols.symbol(columns[0], values[0]);
    int b = symbols.symbol(columns[1], values[1]);
    if (counts[a * size + b] == 0) {
      increment(a, b);
      flip(once, a, b);
      counts[a * size + b] = NOT_REQUIRED;
      counts[b * size + a] = NOT_REQUIRED;
      required--;
    }
  }

  @Override
  public int cost() {
    return 2 * words + 4;
  }

  @Override
  public int changeCost() {
    return 8 * symbols.columns();
  }
}
