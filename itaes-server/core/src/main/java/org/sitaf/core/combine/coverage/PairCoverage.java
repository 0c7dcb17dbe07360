package org.sitaf.core.combine.coverage;

import java.util.List;
import org.sitaf.core.combine.SeededRandom;

/** Coverage of pairs: a symmetric matrix of counts, and sets of partners for each symbol. */
final class PairCoverage extends BitSetCoverage {
  /** The count of a pair that is not required; too large to ever return to one. */
  private static final int NOT_REQUIRED = 1 << 29;

  private final int[] counts;

  /** The number of uncovered pairs of each symbol. */
  private final int[] open;

  PairCoverage(Symbols symbols, List<int[]> columnPairs) {
    super(symbols, symbols.count());
    this.counts = new int[size * size];
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
  int count(long[] set, int symbol, Row row, int column) {
    return common(set, symbol * words, row, 0);
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
  public Tuple pick(SeededRandom random) {
    int left = random.nextInt(2 * uncovered);
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
