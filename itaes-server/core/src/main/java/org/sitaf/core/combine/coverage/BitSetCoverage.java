package org.sitaf.core.combine.coverage;

/**
 * Coverage of tuples of one fixed size by bit sets of symbols: for each part of a tuple, the
 * symbols that complete it to an uncovered tuple, and those that complete it to a tuple that is
 * covered once. A gain or a loss is then a few bit counts.
 */
abstract class BitSetCoverage implements Coverage {
  final Symbols symbols;

  /** The number of symbols. */
  final int size;

  /** The number of 64-bit words of a set of symbols. */
  final int words;

  final long[] never;
  final long[] once;
  long required;
  int uncovered;

  /**
   * Creates a coverage without required tuples.
   *
   * @param sets number of sets of symbols
   */
  BitSetCoverage(Symbols symbols, int sets) {
    this.symbols = symbols;
    this.size = symbols.count();
    this.words = symbols.words();
    this.never = new long[sets * words];
    this.once = new long[sets * words];
  }

  /** The number of tuples in a set that consist of a symbol and other cells of the row. */
  abstract int count(long[] set, int symbol, Row row, int column);

  @Override
  public final long required() {
    return required;
  }

  @Override
  public final int uncovered() {
    return uncovered;
  }

  @Override
  public final int gain(Row row, int column, int value) {
    return count(never, symbols.symbol(column, value), row, column);
  }

  @Override
  public final int loss(Row row, int column) {
    return count(once, row.chosen[column], row, column);
  }

  @Override
  public final void gains(Row row, int column, int[] out) {
    for (int v = 0; v < symbols.levels(column); v++) {
      out[v] = gain(row, column, v);
    }
  }

  /** The number of members that a set has in common with the row, from a word on. */
  final int common(long[] set, int base, Row row, int fromWord) {
    int sum = 0;
    for (int w = fromWord; w < words; w++) {
      sum += Long.bitCount(set[base + w] & row.bits[w]);
    }
    return sum;
  }

  /** The {@code n}-th member (from 0) of the set that starts at word {@code base}. */
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
}
