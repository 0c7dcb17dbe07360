package org.sitaf.core.combine.coverage;

import java.util.Arrays;
import java.util.List;
import org.sitaf.core.combine.SeededRandom;

/**
 * Coverage of triples: a count per triple, and for each symbol and each partner the sets of third
 * symbols of later columns.
 */
final class TripleCoverage extends BitSetCoverage {
  private static final short NOT_REQUIRED = 16384;

  /** Maximum number of symbols: with more, the bit sets use too much memory. */
  private static final int MAX_SYMBOLS = 700;

  /** Maximum number of rows: with more, the counts could overflow. */
  private static final int MAX_ROWS = 12_000;

  private final short[] counts;
  private final int[] countsAt;
  private final int[] openOfFirst;
  private final int[] openOfPair;

  TripleCoverage(Symbols symbols, List<int[]> columnTriples) {
    super(symbols, symbols.count() * symbols.count());
    this.countsAt = new int[size * size];
    this.openOfFirst = new int[size];
    this.openOfPair = new int[size * size];
    this.counts = new short[layOut()];
    Arrays.fill(counts, NOT_REQUIRED);
    for (int[] t : columnTriples) {
      for (int a = symbols.first(t[0]); a < symbols.first(t[0] + 1); a++) {
        for (int b = symbols.first(t[1]); b < symbols.first(t[1] + 1); b++) {
          for (int c = symbols.first(t[2]); c < symbols.first(t[2] + 1); c++) {
            counts[countsAt[a * size + b] + c] = 0;
            opened(a, b, c, 1);
          }
        }
      }
    }
    required = uncovered;
  }

  /** Whether a problem is small enough. */
  static boolean fits(Symbols symbols) {
    int[] sorted = symbols.levels();
    Arrays.sort(sorted);
    int k = sorted.length;
    long largest = (long) sorted[k - 1] * sorted[k - 2] * sorted[k - 3];
    long counted = 0;
    for (int c = 0; c < k; c++) {
      for (int d = c + 1; d < k; d++) {
        counted +=
            (long) symbols.levels(c) * symbols.levels(d) * (symbols.count() - symbols.first(d + 1));
      }
    }
    return symbols.count() <= MAX_SYMBOLS && 4 * largest <= MAX_ROWS && counted < (1 << 28);
  }

  /**
   * Assigns each pair of symbols of ascending columns a range of counts, one per symbol of later
   * columns.
   */
  private int layOut() {
    int at = 0;
    for (int a = 0; a < size; a++) {
      for (int b = symbols.first(symbols.column(a) + 1); b < size; b++) {
        int later = symbols.first(symbols.column(b) + 1);
        countsAt[a * size + b] = at - later;
        at += size - later;
      }
    }
    return at;
  }

  private void opened(int a, int b, int c, int sign) {
    flip(never, a, b, c);
    openOfFirst[a] += sign;
    openOfPair[a * size + b] += sign;
    uncovered += sign;
  }

  private void flip(long[] set, int a, int b, int c) {
    long bitC = 1L << c;
    set[(a * size + b) * words + (c >>> 6)] ^= bitC;
    set[(b * size + a) * words + (c >>> 6)] ^= bitC;
    set[(c * size + a) * words + (b >>> 6)] ^= 1L << b;
  }

  @Override
  int count(long[] set, int symbol, Row row, int column) {
    int sum = 0;
    int[] chosen = row.chosen;
    int slice = symbol * size;
    for (int d = 0; d < chosen.length; d++) {
      int partner = chosen[d];
      if (d != column && partner >= 0) {
        sum += common(set, (slice + partner) * words, row, partner >>> 6);
      }
    }
    return sum;
  }

  @Override
  public void add(Row row) {
    int[] s = row.chosen;
    for (int i = 0; i < s.length; i++) {
      for (int j = i + 1; j < s.length; j++) {
        for (int k = j + 1; k < s.length; k++) {
          increment(s[i], s[j], s[k]);
        }
      }
    }
  }

  @Override
  public void remove(Row row) {
    int[] s = row.chosen;
    for (int i = 0; i < s.length; i++) {
      for (int j = i + 1; j < s.length; j++) {
        for (int k = j + 1; k < s.length; k++) {
          decrement(s[i], s[j], s[k]);
        }
      }
    }
  }

  @Override
  public void change(Row row, int column, int value) {
    int[] s = row.chosen;
    int before = s[column];
    int after = symbols.symbol(column, value);
    for (int i = 0; i < s.length; i++) {
      for (int j = i + 1; i != column && j < s.length; j++) {
        if (j == column) {
          continue;
        }
        if (column < i) {
          decrement(before, s[i], s[j]);
          increment(after, s[i], s[j]);
        } else if (column < j) {
          decrement(s[i], before, s[j]);
          increment(s[i], after, s[j]);
        } else {
          decrement(s[i], s[j], before);
          increment(s[i], s[j], after);
        }
      }
    }
    row.set(column, value);
  }

  private void increment(int a, int b, int c) {
    int n = ++counts[countsAt[a * size + b] + c];
    if (n == 1) {
      opened(a, b, c, -1);
      flip(once, a, b, c);
    } else if (n == 2) {
      flip(once, a, b, c);
    }
  }

  private void decrement(int a, int b, int c) {
    int n = --counts[countsAt[a * size + b] + c];
    if (n == 0) {
      opened(a, b, c, 1);
      flip(once, a, b, c);
    } else if (n == 1) {
      flip(once, a, b, c);
    }
  }

  @Override
  public Tuple pick(SeededRandom random) {
    int left = random.nextInt(uncovered);
    int a = 0;
    while (left >= openOfFirst[a]) {
      left -= openOfFirst[a++];
    }
    int b = symbols.first(symbols.column(a) + 1);
    while (left >= openOfPair[a * size + b]) {
      left -= openOfPair[a * size + b++];
    }
    int c = nth(never, (a * size + b) * words, left);
    return new Tuple(
        new int[] {symbols.column(a), symbols.column(b), symbols.column(c)},
        new int[] {symbols.value(a), symbols.value(b), symbols.value(c)});
  }

  @Override
  public void exclude(int[] columns, int[] values) {
    if (columns.length != 3) {
      return;
    }
    int a = symbols.symbol(columns[0], values[0]);
    int b = symbols.symbol(columns[1], values[1]);
    int c = symbols.symbol(columns[2], values[2]);
    int at = countsAt[a * size + b] + c;
    if (counts[at] == 0) {
      opened(a, b, c, -1);
      counts[at] = NOT_REQUIRED;
      required--;
    }
  }

  @Override
  public int cost() {
    return symbols.columns() * (words + 3);
  }

  @Override
  public int changeCost() {
    return 4 * symbols.columns() * symbols.columns();
  }
}
