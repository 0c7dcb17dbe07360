package org.sitaf.core.sequence.array;

import java.util.List;
import java.util.Optional;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/**
 * Searches permutations that contain every t-tuple of distinct letters as a subsequence, by
 * simulated annealing over a fixed number of permutations. A step moves one letter so that an
 * uncovered tuple becomes more complete. Sequence covering arrays: Kuhn, Higdon, Lawrence, Kacker,
 * Lei: Combinatorial methods for event sequence testing (2012); Chee, Colbourn, Horsley, Zhou:
 * Sequence covering arrays (2013).
 */
final class PermutationSearch {
  private static final double HOT = 0.9;
  private static final double COLD = 0.18;

  private final TupleSpace space;
  private final Uncovered uncovered;
  private final SeededRandom random;
  private final int letters;
  private final int strength;
  private final int[][] words;
  private final int[][] placeOf;

  PermutationSearch(TupleSpace space, int count, long seed) {
    this.space = space;
    this.letters = space.letters();
    this.strength = space.strength();
    this.uncovered = new Uncovered(space.size(), space::isDistinct);
    this.random = new SeededRandom(seed);
    this.words = new int[count][];
    this.placeOf = new int[count][letters];
  }

  /** The permutations; empty if the budget did not suffice. */
  Optional<List<int[]>> search(Budget budget) {
    restart();
    long total = Math.max(1, budget.remaining());
    while (uncovered.size() > 0 && !budget.isExhausted()) {
      double used = 1 - (double) budget.remaining() / total;
      double temperature = HOT * Math.pow(COLD / HOT, used);
      for (int i = 0; i < 64 && uncovered.size() > 0; i++) {
        budget.spend(step(temperature));
      }
    }
    if (uncovered.size() > 0) {
      return Optional.empty();
    }
    return Optional.of(List.of(words));
  }

  private void restart() {
    uncovered.clear();
    for (int w = 0; w < words.length; w++) {
      int[] word = new int[letters];
      for (int i = 0; i < letters; i++) {
        word[i] = i;
      }
      random.shuffle(word);
      words[w] = word;
      for (int i = 0; i < letters; i++) {
        placeOf[w][word[i]] = i;
      }
      Subsequences.forEach(word, letters, strength, uncovered::add);
    }
  }

  /** Moves one letter of an uncovered tuple; returns the number of operations. */
  private long step(double temperature) {
    int[] tuple = space.letters(uncovered.member(random.nextInt(uncovered.size())));
    int w = random.nextInt(words.length);
    int[] place = placeOf[w];
    int i = random.nextInt(strength);
    int before = i == 0 ? -1 : place[tuple[i - 1]];
    int after = i == strength - 1 ? letters : place[tuple[i + 1]];
    int from = place[tuple[i]];
    if (before > after || (from > before && from < after)) {
      return 1;
    }
    // The places between the two neighbours once the letter itself is taken out.
    int low = from < before ? before : before + 1;
    int high = from > after ? after : after - 1;
    int to = low + (high > low ? random.nextInt(high - low + 1) : 0);
    if (to < 0 || to >= letters || to == from) {
      return 1;
    }
    int old = uncovered.size();
    long operations = move(w, from, to);
    int worse = uncovered.size() - old;
    if (worse > 0 && random.nextDouble() >= Math.exp(-worse / temperature)) {
      operations += move(w, to, from);
    }
    return operations;
  }

  /** Moves a letter by swapping neighbours; returns the number of changed tuples. */
  private long move(int w, int from, int to) {
    long operations = 0;
    int step = from < to ? 1 : -1;
    for (int p = from; p != to; p += step) {
      operations += swap(w, Math.min(p, p + step));
    }
    return operations;
  }

  private long swap(int w, int p) {
    int[] word = words[w];
    long changed = changeBoth(word, p, 0, 0, 0, strength);
    int x = word[p];
    word[p] = word[p + 1];
    word[p + 1] = x;
    placeOf[w][word[p]] = p;
    placeOf[w][word[p + 1]] = p + 1;
    return changed + 1;
  }

  /** Replaces the tuples that hold both letters at p and p+1 by those in the other order. */
  private long changeBoth(int[] word, int p, int from, int old, int changed, int left) {
    long count = 0;
    // Letters before p.
    if (left > 2) {
      for (int i = from; i < p; i++) {
        count +=
            changeBoth(
                word, p, i + 1, old * letters + word[i], changed * letters + word[i], left - 1);
      }
    }
    int oldBoth = (old * letters + word[p]) * letters + word[p + 1];
    int newBoth = (changed * letters + word[p + 1]) * letters + word[p];
    return count + changeRest(word, p + 2, oldBoth, newBoth, left - 2);
  }

  private long changeRest(int[] word, int from, int old, int changed, int left) {
    if (left == 0) {
      uncovered.add(changed);
      uncovered.remove(old);
      return 1;
    }
    long count = 0;
    for (int i = from; i < letters; i++) {
      count +=
          changeRest(word, i + 1, old * letters + word[i], changed * letters + word[i], left - 1);
    }
    return count;
  }
}
