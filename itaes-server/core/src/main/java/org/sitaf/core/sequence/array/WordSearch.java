package org.sitaf.core.sequence.array;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/**
 * Searches words of one length that contain every required t-tuple of letters as a subsequence, by
 * simulated annealing over a fixed number of words. A step changes one letter of a word so that an
 * uncovered tuple becomes more complete there. A place may be empty.
 */
final class WordSearch {
  /** A place without a letter. */
  static final int EMPTY = -1;

  private static final double HOT = 0.3;
  private static final double COLD = 0.12;

  private final TupleSpace space;
  private final Uncovered uncovered;
  private final SeededRandom random;
  private final int letters;
  private final int strength;
  private final int[][] words;
  private final Symmetry symmetry;
  private final int[] classOf;
  private final Predicate<int[]> executable;

  /**
   * @param words where the search starts, all of one length
   * @param symmetry under which the required and executable words are closed
   * @param executable which words are possible
   */
  WordSearch(
      TupleSpace space,
      IntPredicate required,
      List<int[]> words,
      Symmetry symmetry,
      Predicate<int[]> executable,
      long seed) {
    this.space = space;
    this.letters = space.letters();
    this.strength = space.strength();
    this.symmetry = symmetry;
    this.classOf = symmetry.classes(space);
    this.uncovered =
        new Uncovered(space.size(), tuple -> required.test(tuple) && classOf[tuple] == tuple);
    this.random = new SeededRandom(seed);
    this.words = words.stream().map(int[]::clone).toArray(int[][]::new);
    this.executable = executable;
  }

  /** The words; empty if the budget did not suffice. */
  Optional<List<int[]>> search(Budget budget) {
    uncovered.clear();
    for (int[] word : words) {
      budget.spend(add(word));
    }
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
    List<int[]> all = new ArrayList<>();
    for (int[] word : words) {
      all.addAll(symmetry.orbit(word));
    }
    return Optional.of(all);
  }

  private long add(int[] word) {
    return change(word, -1, 0, EMPTY, EMPTY, false, 0, 0, strength);
  }

  private long step(double temperature) {
    List<int[]> orbit =
        symmetry.orbit(space.letters(uncovered.member(random.nextInt(uncovered.size()))));
    int[] tuple = orbit.get(random.nextInt(orbit.size()));
    int[] word = words[random.nextInt(words.length)];
    int[] places = nearest(word, tuple);
    int wrong = 0;
    for (int i = 0; i < strength; i++) {
      wrong += word[places[i]] == tuple[i] ? 0 : 1;
    }
    int chosen = random.nextInt(wrong);
    for (int i = 0; i < strength; i++) {
      if (word[places[i]] != tuple[i] && chosen-- == 0) {
        return (long) (word.length + 4 * orbit.size()) * strength
            + replace(word, places[i], tuple[i], temperature);
      }
    }
    return 1;
  }

  private long replace(int[] word, int place, int letter, double temperature) {
    int old = word[place];
    word[place] = letter;
    if (!executable.test(word)) {
      word[place] = old;
      return word.length;
    }
    int before = uncovered.size();
    long operations = change(word, place, 0, old, letter, false, 0, 0, strength);
    int worse = uncovered.size() - before;
    if (worse > 0 && random.nextDouble() >= Math.exp(-worse / temperature)) {
      word[place] = old;
      operations += change(word, place, 0, letter, old, false, 0, 0, strength);
    }
    return operations;
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

  /**
   * Replaces the tuples of one place by those with another letter there; with no place, adds all.
   */
  private long change(
      int[] word,
      int place,
      int from,
      int oldLetter,
      int newLetter,
      boolean held,
      int old,
      int changed,
      int left) {
    if (left == 0) {
      if (place < 0) {
        uncovered.add(classOf[changed]);
      } else if (held) {
        if (newLetter != EMPTY) {
          uncovered.add(classOf[changed]);
        }
        if (oldLetter != EMPTY) {
          uncovered.remove(classOf[old]);
        }
      }
      return 1;
    }
    long count = 0;
    for (int i = from; i <= word.length - left; i++) {
      if (i == place) {
        count +=
            change(
                word,
                place,
                i + 1,
                oldLetter,
                newLetter,
                true,
                old * letters + Math.max(0, oldLetter),
                changed * letters + Math.max(0, newLetter),
                left - 1);
      } else if (word[i] != EMPTY && (held || left > 1 || place < 0)) {
        if (!held && place >= 0 && i > place) {
          break;
        }
        count +=
            change(
                word,
                place,
                i + 1,
                oldLetter,
                newLetter,
                held,
                old * letters + word[i],
                changed * letters + word[i],
                left - 1);
      }
    }
    return count;
  }
}
