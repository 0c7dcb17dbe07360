package org.sitaf.core.sequence.array;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/**
 * Searches words of one length that contain every t-tuple of letters as a subsequence, where each
 * word is possible: by simulated annealing over a fixed number of words. A step changes one letter
 * or exchanges two, and updates how often each tuple occurs. With a {@link Symmetry}, tuples that
 * are images of each other count as one, and all images of each word are used.
 */
final class FreeWordSearch {
  private static final double HOT = 0.3;
  private static final double COLD = 0.15;

  /** One of so many steps exchanges two letters; the others change one. */
  private static final int EXCHANGES = 4;

  /** Operations of a step besides those for its tuples, which are two for each. */
  private static final int STEP = 20;

  /** Steps between two updates of the temperature. */
  private static final int ROUND = 256;

  private final int letters;
  private final int strength;
  private final int length;
  private final Symmetry symmetry;
  private final SeededRandom random;

  /** The number of each tuple's class of images. */
  private final int[] classOf;

  private final int[] occurrences;
  private final int[][] words;
  private int missing;

  /**
   * @param space of at least two letters
   * @param count number of words, a multiple of the symmetry's order
   */
  FreeWordSearch(TupleSpace space, int length, int count, Symmetry symmetry, long seed) {
    this.letters = space.letters();
    this.strength = space.strength();
    this.length = length;
    this.symmetry = symmetry;
    this.random = new SeededRandom(seed);
    this.classOf = new int[space.size()];
    this.missing = classes(space);
    this.occurrences = new int[space.size()];
    this.words = new int[count / symmetry.order()][length];
  }

  private int classes(TupleSpace space) {
    int count = 0;
    for (int t = 0; t < space.size(); t++) {
      int smallest = t;
      for (int[] image : symmetry.orbit(space.letters(t))) {
        smallest = Math.min(smallest, space.index(image));
      }
      classOf[t] = smallest;
      count += smallest == t ? 1 : 0;
    }
    return count;
  }

  /** The words; empty if the budget did not suffice. */
  Optional<List<int[]>> search(Budget budget) {
    budget.spend(
        (long) classOf.length * symmetry.order() + words.length * length * changedTuples());
    for (int[] word : words) {
      for (int p = 0; p < length; p++) {
        word[p] = random.nextInt(letters);
      }
      Subsequences.forEach(word, letters, strength, this::add);
    }
    long total = Math.max(1, budget.remaining());
    long operations = ROUND * (2 * changedTuples() + STEP);
    while (missing > 0 && !budget.isExhausted()) {
      double used = 1 - (double) budget.remaining() / total;
      double temperature = HOT * Math.pow(COLD / HOT, used);
      for (int i = 0; i < ROUND && missing > 0; i++) {
        step(words[random.nextInt(words.length)], temperature);
      }
      budget.spend(operations);
    }
    if (missing > 0) {
      return Optional.empty();
    }
    List<int[]> all = new ArrayList<>();
    for (int[] word : words) {
      all.addAll(symmetry.orbit(word));
    }
    return Optional.of(all);
  }

  /** The number of classes of tuples that no word contains. */
  int missing() {
    return missing;
  }

  /** Tuples of a word that contain one place. */
  private long changedTuples() {
    long count = 1;
    for (int i = 1; i < strength; i++) {
      count = count * (length - i) / i;
    }
    return Math.max(1, count);
  }

  private void step(int[] word, double temperature) {
    int before = missing;
    int place = random.nextInt(length);
    int letter = word[place];
    if (random.nextInt(EXCHANGES) > 0) {
      int other = random.nextInt(letters - 1);
      replace(word, place, other < letter ? other : other + 1);
      if (isRejected(missing - before, temperature)) {
        replace(word, place, letter);
      }
      return;
    }
    int otherPlace = random.nextInt(length);
    int other = word[otherPlace];
    if (other != letter) {
      replace(word, place, other);
      replace(word, otherPlace, letter);
      if (isRejected(missing - before, temperature)) {
        replace(word, place, letter);
        replace(word, otherPlace, other);
      }
    }
  }

  private boolean isRejected(int worse, double temperature) {
    return worse > 0 && random.nextDouble() >= Math.exp(-worse / temperature);
  }

  private void replace(int[] word, int place, int letter) {
    int old = word[place];
    if (strength == 3) {
      replaceOfThree(word, place, old, letter);
    } else {
      replace(word, place, 0, 0, 0, strength, letter);
    }
    word[place] = letter;
  }

  /** Exchanges the tuples with the place for those with another letter there. */
  private void replace(
      int[] word, int place, int from, int old, int changed, int left, int letter) {
    if (left == 0) {
      exchange(old, changed);
      return;
    }
    boolean isOpen = from <= place;
    int first = isOpen && left == 1 ? place : from;
    int last = isOpen ? place : length - left;
    for (int p = first; p <= last; p++) {
      replace(
          word,
          place,
          p + 1,
          old * letters + word[p],
          changed * letters + (p == place ? letter : word[p]),
          left - 1,
          letter);
    }
  }

  private void replaceOfThree(int[] word, int place, int old, int letter) {
    int square = letters * letters;
    for (int i = 0; i < place; i++) {
      int first = word[i] * square;
      for (int j = i + 1; j < place; j++) {
        int both = first + word[j] * letters;
        exchange(both + old, both + letter);
      }
      for (int j = place + 1; j < length; j++) {
        int outer = first + word[j];
        exchange(outer + old * letters, outer + letter * letters);
      }
    }
    for (int i = place + 1; i < length; i++) {
      int middle = word[i] * letters;
      for (int j = i + 1; j < length; j++) {
        int both = middle + word[j];
        exchange(old * square + both, letter * square + both);
      }
    }
  }

  private void exchange(int old, int changed) {
    int lost = classOf[old];
    if (--occurrences[lost] == 0) {
      missing++;
    }
    add(changed);
  }

  private void add(int tuple) {
    if (occurrences[classOf[tuple]]++ == 0) {
      missing--;
    }
  }
}
