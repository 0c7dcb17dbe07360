package org.sitaf.core.sequence.array;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.search.Budget;

/** Searches for few words that contain every required tuple as a subsequence. */
public final class SequenceCovering {
  private static final long DEFAULT_OPERATIONS = 100_000_000L;
  private static final long BEST_OPERATIONS = 3_000_000_000L;

  /** Number of required tuples for which the operations of a search for words are meant. */
  private static final int TUPLES = 16;

  /** How often the operations are taken at most, without guards and with them. */
  private static final int MOST_FREE = 12;

  private static final int MOST_GUARDED = 3;

  /** Number of words beyond which the operations never suffice for fewer. */
  private static final int MOST_REDUCED = 200;

  /** Operations of all searches for symmetric words as a share of all. */
  private static final double ALL_SYMMETRIC = 0.25;

  /** Operations of one search for symmetric words as a share of those. */
  private static final double SYMMETRIC = 0.04;

  /** Operations of one search for words without symmetry as a share of all. */
  private static final double FREE = 0.25;

  /** Number of missing tuples, besides a fiftieth of all, after which no attempt is made. */
  private static final int HOPELESS = 3;

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
   */
  public List<int[]> reduce(
      List<int[]> words, int length, BitSet required, Predicate<int[]> executable) {
    Budget budget = budget(required.cardinality(), MOST_GUARDED);
    List<int[]> best = words;
    int least = least(required.cardinality(), length);
    double share = ATTEMPT / 4;
    for (long attempt = 0; best.size() > least && !budget.isExhausted(); attempt++) {
      WordSearch search =
          new WordSearch(
              space, required::get, allButLast(best, length), executable, seed + attempt);
      Optional<List<int[]>> found = search.search(budget.part(share));
      if (found.isPresent()) {
        best = found.get();
        progress.report(best.size(), budget.share());
      } else if (search.missing() > hopeless(required.cardinality())) {
        break;
      } else {
        // Another attempt for the same number of words is longer.
        share *= 2;
      }
    }
    return best;
  }

  /**
   * Reduces the number of words where every word over the letters is possible and every tuple is
   * required. Symmetric words are found faster than others, but do not exist for each number.
   */
  public List<int[]> reduceFree(List<int[]> words, int length) {
    if (space.letters() < 2 || words.size() > MOST_REDUCED) {
      return words;
    }
    Budget budget = budget(space.size(), MOST_FREE);
    int least = least(space.size(), length);
    List<int[]> best = symmetric(words, length, budget.part(ALL_SYMMETRIC));
    progress.report(best.size(), budget.share());
    for (long attempt = 0; best.size() > least && !budget.isExhausted(); attempt++) {
      FreeWordSearch search =
          new FreeWordSearch(space, length, best.size() - 1, Symmetry.NONE, seed + attempt);
      Optional<List<int[]>> found = search.search(budget.part(FREE));
      if (found.isPresent()) {
        best = found.get();
        progress.report(best.size(), budget.share());
      } else if (search.missing() > hopeless(space.size())) {
        break;
      }
    }
    return best;
  }

  /** The fewest symmetric words that are found for any number between half of the words and all. */
  private List<int[]> symmetric(List<int[]> words, int length, Budget budget) {
    List<int[]> best = words;
    int fewest = Math.max(least(space.size(), length), words.size() / 2);
    int missing = 0;
    for (int count = words.size() - 1;
        count >= fewest && missing <= hopeless(space.size()) && !budget.isExhausted();
        count--) {
      List<Symmetry> symmetries = symmetries(count);
      // A number without a symmetry, such as a prime, tells nothing about smaller ones.
      missing = symmetries.isEmpty() ? missing : Integer.MAX_VALUE;
      for (Symmetry symmetry : symmetries) {
        if (missing > 0 && !budget.isExhausted()) {
          FreeWordSearch search = new FreeWordSearch(space, length, count, symmetry, seed);
          best = search.search(budget.part(SYMMETRIC)).orElse(best);
          missing = Math.min(missing, search.missing());
        }
      }
    }
    return best;
  }

  private Budget budget(int required, int mostTimes) {
    return new Budget(operations * Math.max(1, Math.min(required / TUPLES, mostTimes)));
  }

  /** Number of missing tuples after which no further attempt is made. */
  private static int hopeless(int required) {
    return HOPELESS + required / 50;
  }

  /** A lower bound of the number of words: each holds a tuple for each choice of places. */
  private int least(int tuples, int length) {
    double inWord = 1;
    for (int i = 0; i < space.strength(); i++) {
      inWord = inWord * (length - i) / (i + 1);
    }
    return (int) Math.max(1, Math.ceil(tuples / inWord));
  }

  /** The cyclic symmetries whose order divides a number of words. */
  private List<Symmetry> symmetries(int words) {
    List<Symmetry> all = new ArrayList<>();
    for (int cycle = 2; cycle <= Math.min(space.letters(), words); cycle++) {
      if (words % cycle == 0) {
        all.add(Symmetry.cyclic(space.letters(), cycle));
      }
    }
    return all;
  }

  /** All words but the last one, padded to the length. */
  private static List<int[]> allButLast(List<int[]> words, int length) {
    List<int[]> start = new ArrayList<>();
    for (int w = 0; w < words.size() - 1; w++) {
      int[] word = new int[length];
      Arrays.fill(word, WordSearch.EMPTY);
      System.arraycopy(words.get(w), 0, word, 0, words.get(w).length);
      start.add(word);
    }
    return start;
  }
}
