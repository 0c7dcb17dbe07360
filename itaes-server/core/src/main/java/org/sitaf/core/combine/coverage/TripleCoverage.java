package org.sitaf.core.combine.coverage;

import java.util.Arrays;
import java.util.List;

/**
 * Coverage of triples. For a symbol {@code x} and a partner {@code y} the sets of third symbols, of
 * columns after {@code y}'s, with which they are uncovered, or covered once: a gain is a walk over
 * the row's cells with a few bit counts each.
 */
final class TripleCoverage implements Coverage {
  private static final short NOT_REQUIRED = 16384;

  /** Above this many symbols the cube of bits is too large. */
  private static final int MAX_SYMBOLS = 700;

  /** Above this many rows the counts might run over. */
  private static final int MAX_ROWS = 12_000;

  private final Symbols symbols;
  private final int size;
  private final int words;
  private final short[] counts;
  private final int[] countsAt;
  private final long[] never;
  private final long[] once;
  private final int[] openOfFirst;
  private final int[] openOfPair;
  private long required;
  private int uncovered;

  TripleCoverage(Symbols symbols, List<int[]> columnTriples) {
    this.symbols = symbols;
    this.size = symbols.count();
    this.words = symbols.words();
    this.never = new long[size * size * words];
    this.once = new long[size * size * words];
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

  /** Whether a problem fits. */
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

  /** Gives each pair of symbols of ascending columns a run of counts, one per later symbol. */
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
  public long required() {
    return required;
  }

  @Override
  public int uncovered() {
    return uncovered;
  }

  @Override
  public int gain(Row row, int column, int value) {
    return common(never, symbols.symbol(column, value), row, column);
  }

  @Override
  public int loss(Row row, int column) {
    return common(once, row.chosen[column], row, column);
  }

  private int common(long[] set, int symbol, Row row, int column) {
    int sum = 0;
    int[] chosen = row.chosen;
    long[] bits = row.bits;
    int slice = symbol * size;
    for (int d = 0; d < chosen.length; d++) {
      int partner = chosen[d];
      if (d != column && partner >= 0) {
        int base = (slice + partner) * words;
        for (int w = partner >>> 6; w < words; w++) {
          sum += Long.bitCount(set[base + w] & bits[w]);
        }
      }
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
  public Tuple pick(Dice dice) {
    int left = dice.below(uncovered);
    int a = 0;
    while (left >= openOfFirst[a]) {
      left -= openOfFirst[a++];
    }
    int b = symbols.first(symbols.column(a) + 1);
    while (left >= openOfPair[a * size + b]) {
      left -= openOfPair[a * size + b++];
    }
    int c = PairCoverage.nth(never, (a * size + b) * words, left);
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
