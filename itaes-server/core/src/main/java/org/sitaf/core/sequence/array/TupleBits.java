package org.sitaf.core.sequence.array;

import java.util.Arrays;

/**
 * Computes the set of t-tuples that a word contains as subsequences, as bits. The last letter of a
 * tuple has the largest weight, so that a letter that is appended to a word adds one block of bits
 * for each length of a tuple.
 */
final class TupleBits {
  /** Operations of a change of a word that do not depend on its length. */
  private static final int OVERHEAD = 60;

  private final int strength;

  /** For each length of a tuple, the number of tuples. */
  private final int[] tuples;

  /** For each length below the strength, the tuples of the word so far. */
  private final long[][] shorter;

  TupleBits(TupleSpace space) {
    int letters = space.letters();
    strength = space.strength();
    tuples = new int[strength + 1];
    shorter = new long[strength][];
    tuples[0] = 1;
    for (int i = 0; i < strength; i++) {
      shorter[i] = new long[longs(tuples[i])];
      tuples[i + 1] = tuples[i] * letters;
    }
    shorter[0][0] = 1;
  }

  private static int longs(int bits) {
    return (bits + Long.SIZE - 1) / Long.SIZE;
  }

  /** An empty set of tuples. */
  long[] empty() {
    return new long[longs(tuples[strength])];
  }

  /** The letters of the tuple of a bit. */
  int[] tuple(int bit) {
    int[] tuple = new int[strength];
    int rest = bit;
    for (int i = strength - 1; i >= 0; i--) {
      tuple[i] = rest / tuples[i];
      rest %= tuples[i];
    }
    return tuple;
  }

  /** The bit of a tuple. */
  int bit(int[] tuple) {
    int bit = 0;
    for (int i = 0; i < strength; i++) {
      bit += tuple[i] * tuples[i];
    }
    return bit;
  }

  /** The number of operations for a word of a length. */
  long operations(int length) {
    long operations = 0;
    for (int i = 0; i < strength; i++) {
      operations += shorter[i].length;
    }
    return operations * length + 2L * longs(tuples[strength]) + length + OVERHEAD;
  }

  /** Adds the tuples of a word to a set. Negative letters are left out. */
  void add(int[] word, long[] set) {
    for (int i = 1; i < strength; i++) {
      Arrays.fill(shorter[i], 0);
    }
    for (int letter : word) {
      if (letter >= 0) {
        for (int i = strength; i >= 1; i--) {
          append(i == strength ? set : shorter[i], letter * tuples[i - 1], shorter[i - 1]);
        }
      }
    }
  }

  /** Adds a set at a bit of another one. */
  private static void append(long[] to, int bit, long[] set) {
    int at = bit / Long.SIZE;
    int shift = bit % Long.SIZE;
    for (int i = 0; i < set.length; i++) {
      to[at + i] |= set[i] << shift;
      long carried = shift == 0 ? 0 : set[i] >>> (Long.SIZE - shift);
      if (carried != 0) {
        to[at + i + 1] |= carried;
      }
    }
  }

  /** The number of tuples that two sets share. */
  static int common(long[] one, long[] other) {
    int common = 0;
    for (int i = 0; i < one.length; i++) {
      common += Long.bitCount(one[i] & other[i]);
    }
    return common;
  }

  /**
   * A member of a set that is not in another one, by its place among these; -1 if there is none.
   */
  static int member(long[] set, long[] other, int place) {
    int left = place;
    for (int i = 0; i < set.length; i++) {
      long rest = set[i] & ~other[i];
      int count = Long.bitCount(rest);
      if (left < count) {
        for (; left > 0; left--) {
          rest &= rest - 1;
        }
        return i * Long.SIZE + Long.numberOfTrailingZeros(rest);
      }
      left -= count;
    }
    return -1;
  }
}
