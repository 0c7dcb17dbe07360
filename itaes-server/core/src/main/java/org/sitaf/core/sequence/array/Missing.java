package org.sitaf.core.sequence.array;

import java.util.function.IntPredicate;

/** The required tuples that none of several words contains. */
final class Missing {
  private final long[] required;
  private final long[] missing;

  /** In how many words each tuple is. */
  private final int[] words;

  private int size;

  /** Creates the tuples that no words contain: all required ones. */
  Missing(TupleSpace space, TupleBits bits, IntPredicate isRequired) {
    required = bits.empty();
    for (int tuple = 0; tuple < space.size(); tuple++) {
      if (isRequired.test(tuple)) {
        int bit = bits.bit(space.letters(tuple));
        required[bit / Long.SIZE] |= 1L << bit;
        size++;
      }
    }
    missing = required.clone();
    words = new int[space.size()];
  }

  /** The number of missing tuples. */
  int size() {
    return size;
  }

  /** The missing tuples, which change with each word. */
  long[] bits() {
    return missing;
  }

  /** Adds a word by the set of its tuples. */
  void add(long[] word) {
    for (int i = 0; i < word.length; i++) {
      for (long rest = word[i] & required[i]; rest != 0; rest &= rest - 1) {
        if (words[i * Long.SIZE + Long.numberOfTrailingZeros(rest)]++ == 0) {
          missing[i] &= ~Long.lowestOneBit(rest);
          size--;
        }
      }
    }
  }

  /** Removes a word by the set of its tuples. */
  void remove(long[] word) {
    for (int i = 0; i < word.length; i++) {
      for (long rest = word[i] & required[i]; rest != 0; rest &= rest - 1) {
        if (--words[i * Long.SIZE + Long.numberOfTrailingZeros(rest)] == 0) {
          missing[i] |= Long.lowestOneBit(rest);
          size++;
        }
      }
    }
  }
}
