package org.sitaf.core.sequence;

import java.util.BitSet;
import org.sitaf.core.sequence.array.TupleSpace;

/** How often words contain each required tuple. */
final class TupleCount {
  private final TupleSpace space;
  private final BitSet required;
  private final int[] occurrences;
  private int missing;

  TupleCount(TupleSpace space, BitSet required) {
    this.space = space;
    this.required = required;
    this.occurrences = new int[space.size()];
    this.missing = required.cardinality();
  }

  /** Whether each required tuple is in a word. */
  boolean isComplete() {
    return missing == 0;
  }

  void add(int[] word) {
    change(word, 0, 0, space.strength(), 1);
  }

  void remove(int[] word) {
    change(word, 0, 0, space.strength(), -1);
  }

  private void change(int[] word, int from, int tuple, int left, int by) {
    if (left == 0) {
      int before = occurrences[tuple];
      occurrences[tuple] += by;
      if (required.get(tuple)) {
        missing += before == 0 ? -1 : occurrences[tuple] == 0 ? 1 : 0;
      }
      return;
    }
    for (int p = from; p <= word.length - left; p++) {
      change(word, p + 1, tuple * space.letters() + word[p], left - 1, by);
    }
  }
}
