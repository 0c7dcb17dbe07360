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

  /** Operations of one attempt as a share of all. */
  private static final double ATTEMPT = 0.06;

  private final TupleSpace space;
  private final Budget budget;
  private final long seed;
  private final Progress progress;

  /** Prepares a search. The same arguments give the same words. */
  public SequenceCovering(TupleSpace space, Effort effort, long seed, Progress progress) {
    this.space = space;
    this.budget =
        new Budget(
            switch (effort) {
              case FAST -> DEFAULT_OPERATIONS / 20;
              case DEFAULT -> DEFAULT_OPERATIONS;
              case BEST -> BEST_OPERATIONS;
            });
    this.seed = seed;
    this.progress = progress;
  }

  /** Permutations that contain every tuple of distinct letters. */
  public List<int[]> permutations() {
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
          permutations(count, budget.isExhausted() ? new Budget(DEFAULT_OPERATIONS) : attempt(0.3));
      if (found.isEmpty()) {
        failed = count;
        count += 1 + count / 2;
      }
    }
    while (found.get().size() > failed + 1 && !budget.isExhausted()) {
      int next = (failed + found.get().size()) / 2;
      Optional<List<int[]>> smaller = permutations(next, attempt(1));
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

  private Budget attempt(double share) {
    return budget.part(ATTEMPT * share);
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
    List<int[]> best = words;
    boolean smaller = true;
    while (smaller && best.size() > 1 && !budget.isExhausted()) {
      smaller = false;
      for (Symmetry symmetry : symmetries(symmetric, best.size() - 1)) {
        int count = (best.size() - 1) / symmetry.order();
        List<int[]> start = start(best, count, length, symmetric && symmetry.order() > 1);
        Optional<List<int[]>> found =
            new WordSearch(space, required::get, start, symmetry, executable, seed)
                .search(attempt(1));
        if (found.isPresent()) {
          best = found.get();
          smaller = true;
          progress.report(best.size(), budget.share());
          break;
        }
        if (budget.isExhausted()) {
          break;
        }
      }
    }
    return best;
  }

  private List<Symmetry> symmetries(boolean symmetric, int most) {
    int letters = space.letters();
    List<Symmetry> all = new ArrayList<>(List.of(Symmetry.cyclic(letters, 1, false)));
    for (int cycle = letters; symmetric && cycle > 1; cycle--) {
      for (boolean reversal : new boolean[] {false, true}) {
        Symmetry symmetry = Symmetry.cyclic(letters, cycle, reversal);
        if (symmetry.order() <= most && symmetry.order() * 2 > most / 8) {
          all.add(symmetry);
        }
      }
    }
    return all;
  }

  /** The first words, or random ones, padded to the length. */
  private List<int[]> start(List<int[]> words, int count, int length, boolean isRandom) {
    SeededRandom random = new SeededRandom(seed + count);
    List<int[]> start = new ArrayList<>();
    for (int w = 0; w < count; w++) {
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
