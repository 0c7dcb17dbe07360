package org.sitaf.core.sequence.array;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/**
 * Searches words of one length that contain every required t-tuple of letters as a subsequence, by
 * simulated annealing over a fixed number of words. One word at a time is changed in several steps,
 * so that it contains more of the tuples that all others lack. A place may be empty.
 */
final class WordSearch {
  /** A place without a letter. */
  static final int EMPTY = -1;

  private static final double HOT = 0.4;
  private static final double COLD = 0.1;

  /** Changes of one word before the next one is chosen. */
  private static final int CHANGES = 30;

  /** Share of the changes that are made for a chosen tuple. */
  private static final double GUIDED = 0.2;

  private final int letters;
  private final int strength;
  private final TupleBits bits;
  private final Missing missing;
  private final SeededRandom random;
  private final int[][] words;
  private final long[][] tuplesOf;
  private final Predicate<int[]> executable;
  private final boolean mayBeEmpty;

  /**
   * @param required numbers of the tuples
   * @param words where the search starts, all of one length
   * @param executable which words are possible
   */
  WordSearch(
      TupleSpace space,
      IntPredicate required,
      List<int[]> words,
      Predicate<int[]> executable,
      long seed) {
    this.letters = space.letters();
    this.strength = space.strength();
    this.bits = new TupleBits(space);
    this.missing = new Missing(space, bits, required);
    this.random = new SeededRandom(seed);
    this.words = words.stream().map(int[]::clone).toArray(int[][]::new);
    this.mayBeEmpty = words.stream().flatMapToInt(Arrays::stream).anyMatch(l -> l == EMPTY);
    this.tuplesOf = new long[words.size()][];
    for (int w = 0; w < words.size(); w++) {
      tuplesOf[w] = tuples(this.words[w]);
    }
    this.executable = executable;
  }

  private long[] tuples(int[] word) {
    long[] set = bits.empty();
    bits.add(word, set);
    return set;
  }

  /** The words; empty if the budget did not suffice. */
  Optional<List<int[]>> search(Budget budget) {
    for (long[] tuples : tuplesOf) {
      missing.add(tuples);
    }
    long total = Math.max(1, budget.remaining());
    while (missing.size() > 0 && !budget.isExhausted()) {
      double used = 1 - (double) budget.remaining() / total;
      improve(random.nextInt(words.length), HOT * Math.pow(COLD / HOT, used), budget);
    }
    if (missing.size() > 0) {
      return Optional.empty();
    }
    return Optional.of(List.of(words));
  }

  /** The number of tuples that no word contains at the end of the search. */
  int missing() {
    return missing.size();
  }

  /** Changes one word, while the others stay. */
  private void improve(int w, double temperature, Budget budget) {
    missing.remove(tuplesOf[w]);
    int gain = TupleBits.common(tuplesOf[w], missing.bits());
    long operations = bits.operations(words[w].length);
    for (int i = 0; i < CHANGES && gain < missing.size(); i++) {
      budget.spend(operations);
      int[] changed = changed(words[w], tuplesOf[w], missing.size() - gain);
      long[] tuples = tuples(changed);
      int then = TupleBits.common(tuples, missing.bits());
      boolean accepted =
          then >= gain || random.nextDouble() < Math.exp((then - gain) / temperature);
      if (accepted && executable.test(changed)) {
        words[w] = changed;
        tuplesOf[w] = tuples;
        gain = then;
      }
    }
    missing.add(tuplesOf[w]);
  }

  /** A word with one letter replaced, two letters exchanged, or one letter at another place. */
  private int[] changed(int[] word, long[] tuples, int lacking) {
    int[] changed = word.clone();
    if (random.nextDouble() < GUIDED) {
      int bit = TupleBits.member(missing.bits(), tuples, random.nextInt(lacking));
      if (complete(changed, bits.tuple(bit))) {
        return changed;
      }
    }
    int place = random.nextInt(word.length);
    int other = random.nextInt(word.length);
    switch (random.nextInt(4)) {
      case 0 -> {
        changed[place] = word[other];
        changed[other] = word[place];
      }
      case 1 -> move(changed, place, other, random.nextInt(2) == 0 ? word[place] : letter());
      default -> changed[place] = letter();
    }
    return changed;
  }

  private int letter() {
    return mayBeEmpty ? random.nextInt(letters + 1) - 1 : random.nextInt(letters);
  }

  private static void move(int[] word, int from, int to, int letter) {
    if (from < to) {
      System.arraycopy(word, from + 1, word, from, to - from);
    } else {
      System.arraycopy(word, to, word, to + 1, from - to);
    }
    word[to] = letter;
  }

  /** Sets one letter so that a tuple becomes more complete. */
  private boolean complete(int[] word, int[] tuple) {
    int[] places = nearest(word, tuple);
    int wrong = 0;
    int chosen = -1;
    for (int i = 0; i < strength; i++) {
      if (word[places[i]] != tuple[i] && random.nextInt(++wrong) == 0) {
        chosen = i;
      }
    }
    if (chosen >= 0) {
      word[places[chosen]] = tuple[chosen];
    }
    return chosen >= 0;
  }

  /** Increasing places of a word with as many letters of the tuple as possible. */
  private int[] nearest(int[] word, int[] tuple) {
    int length = word.length;
    int[][] best = new int[strength + 1][length + 1];
    for (int i = strength - 1; i >= 0; i--) {
      for (int p = 0; p <= length; p++) {
        best[i][p] = Integer.MIN_VALUE / 2;
      }
      for (int p = length - (strength - i); p >= 0; p--) {
        int taken = (word[p] == tuple[i] ? 1 : 0) + best[i + 1][p + 1];
        best[i][p] = Math.max(best[i][p + 1], taken);
      }
    }
    int[] places = new int[strength];
    int p = 0;
    for (int i = 0; i < strength; i++) {
      // One of the best places, each with the same chance.
      int count = 0;
      for (int q = p; q <= length - (strength - i); q++) {
        int taken = (word[q] == tuple[i] ? 1 : 0) + best[i + 1][q + 1];
        if (taken == best[i][p] && random.nextInt(++count) == 0) {
          places[i] = q;
        }
      }
      p = places[i] + 1;
    }
    return places;
  }
}
