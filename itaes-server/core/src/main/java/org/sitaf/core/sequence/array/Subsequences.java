package org.sitaf.core.sequence.array;

import java.util.function.IntConsumer;

/** The t-tuples that a word contains as subsequences, one for each choice of places. */
public final class Subsequences {
  private Subsequences() {}

  /** Calls an action with the number of each tuple. */
  public static void forEach(int[] word, int letters, int strength, IntConsumer action) {
    forEach(word, letters, 0, 0, strength, action);
  }

  private static void forEach(
      int[] word, int letters, int from, int tuple, int left, IntConsumer action) {
    if (left == 0) {
      action.accept(tuple);
      return;
    }
    for (int i = from; i <= word.length - left; i++) {
      forEach(word, letters, i + 1, tuple * letters + word[i], left - 1, action);
    }
  }
}
