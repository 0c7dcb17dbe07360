package org.sitaf.core.sequence.array;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.search.Budget;

/** Searches for few words that contain every required tuple as a subsequence. */
public final class SequenceCovering {
  private static final long DEFAULT_OPERATIONS = 100_000_000L;
  private static final long BEST_OPERATIONS = 3_000_000_000L;

  /** Number of required tuples for which the operations of a search for words are meant. */
  private static final int TUPLES = 16;

  /** How often the operations are taken at most, without guards and with them. */
  private static final int MOST_FREE = 20;

  private static final int MOST_GUARDED = 3;

  /** Number of missing tuples, besides a fiftieth of all, after which no attempt is made. */
  private static final int HOPELESS = 3;

  /** Maximum number of words without an image in a search for symmetric words. */
  private static final int MOST_SINGLE = 3;

  /** Operations of one attempt as a share of all. */
  private static final double ATTEMPT = 0.06;

  private final TupleSpace space;
  private final long operations;
  private final long seed;
  private final Progress progress;

  /** Prepares a search. The same arguments give the same words. */
  public SequenceCovering(TupleSpace space, Effort effort, long seed, Progress progress) {
    this.space = space;
    this.operations =
        switch (effort) {
          case FAST -> DEFAULT_OPERATIONS / 20;
          case DEFAULT -> DEFAULT_OPERATIONS;
          case BEST -> BEST_OPERATIONS;
        };
    this.seed = seed;
    this.progress = progress;
  }

  /** Permutations that contain every tuple of distinct letters. */
  public List<int[]> permutations() {
    Budget budget = new Budget(operations);
    int strength = space.strength();
    int failed = 0;
    int count = 1;
    for (int i = 2; i <= Math.min(strength, space.letters()); i++) {
      count *= i;
    }
    Optional<List<int[]>> found = Optional.empty();
    while (found.isEmpty()) {
      // Without a bound on the operations, an array that is large enough is always found.
      found =
          permutations(
              count,
              budget.isExhausted() ? new Budget(DEFAULT_OPERATIONS) : budget.part(0.3 * ATTEMPT));
      if (found.isEmpty()) {
        failed = count;
        count += 1 + count / 2;
      }
    }
    while (found.get().size() > failed + 1 && !budget.isExhausted()) {
      int next = (failed + found.get().size()) / 2;
      Optional<List<int[]>> smaller = permutations(next, budget.part(ATTEMPT));
      if (smaller.isPresent()) {
        found = smaller;
        progress.report(found.get().size(), budget.share());
      } else {
        failed = next;
      }
    }
    return found.get();
  }

  private Optional<List<int[]>> permutations(int count, Budget operations) {
    return new PermutationSearch(space, count, seed).search(operations);
  }

  /**
   * Reduces the number of words.
   *
   * @param words that cover all required tuples, of at most the length
   * @param executable which words are possible; negative letters are empty places
   * @param symmetric whether every word over the letters is possible and every tuple required
   */
  public List<int[]> reduce(
      List<int[]> words,
      int length,
      BitSet required,
      Predicate<int[]> executable,
      boolean symmetric) {
    int factor = Math.min(required.cardinality() / TUPLES, symmetric ? MOST_FREE : MOST_GUARDED);
    Budget budget = new Budget(operations * Math.max(1, factor));
    List<int[]> best = words;
    int least = least(required.cardinality(), length);
    double share = ATTEMPT / 4;
    for (long attempt = 0; best.size() > least && !budget.isExhausted(); attempt++) {
      boolean smaller = false;
      int missing = Integer.MAX_VALUE;
      for (Symmetry symmetry : symmetries(symmetric, best.size() - 1)) {
        List<int[]> start = start(best, length, symmetric, seed + attempt);
        WordSearch search =
            new WordSearch(space, required::get, start, symmetry, executable, seed + attempt);
        Optional<List<int[]>> found = search.search(budget.part(share));
        missing = Math.min(missing, search.missing());
        if (found.isPresent()) {
          best = found.get();
          smaller = true;
          progress.report(best.size(), budget.share());
          break;
        }
      }
      if (missing > HOPELESS + required.cardinality() / 50) {
        break;
      }
      // Another attempt for the same number of words is longer.
      share *= smaller ? 1 : 2;
    }
    return best;
  }

  /** A lower bound of the number of words: each holds a tuple for each choice of places. */
  private int least(int tuples, int length) {
    double inWord = 1;
    for (int i = 0; i < space.strength(); i++) {
      inWord = inWord * (length - i) / (i + 1);
    }
    return (int) Math.max(1, Math.ceil(tuples / inWord));
  }

  private List<Symmetry> symmetries(boolean symmetric, int words) {
    int letters = space.letters();
    List<Symmetry> all = new ArrayList<>(List.of(Symmetry.NONE));
    for (int cycle : symmetric ? new int[] {2, letters - 1, letters} : new int[0]) {
      Symmetry symmetry = Symmetry.cyclic(letters, Math.max(1, cycle));
      if (symmetry.order() > 1
          && symmetry.order() <= words
          && words % symmetry.order() <= MOST_SINGLE) {
        all.add(symmetry);
      }
    }
    return all;
  }

  /** All words but the last one, or random ones, padded to the length. */
  private List<int[]> start(List<int[]> words, int length, boolean isRandom, long seed) {
    SeededRandom random = new SeededRandom(seed);
    List<int[]> start = new ArrayList<>();
    for (int w = 0; w < words.size() - 1; w++) {
      int[] word = new int[length];
      if (isRandom) {
        for (int p = 0; p < length; p++) {
          word[p] = random.nextInt(space.letters());
        }
      } else {
        Arrays.fill(word, WordSearch.EMPTY);
        System.arraycopy(words.get(w), 0, word, 0, words.get(w).length);
      }
      start.add(word);
    }
    return start;
  }
}
