package org.sitaf.core.bisect;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.OptionalInt;

/**
 * Finds the first bad commit of a history. Each test excludes either the tested commit and what it
 * is based on, or everything else, so that about log2(n) tests are needed for n commits.
 *
 * <p>Commits are numbers from 0. The last one is bad, and what the history is based on is good.
 */
public final class Bisection {
  /** Part of the candidates by which the next commit is away from one that could not be tested. */
  private static final int AWAY = 16;

  /** What the test of a commit shows. */
  public enum Outcome {
    GOOD,
    BAD,
    /** The commit cannot be tested, for example because it does not compile. */
    SKIPPED
  }

  /** Each commit with all commits of the history that it is based on. */
  private final List<BitSet> closures;

  private final BitSet candidates;
  private final BitSet tested = new BitSet();
  private final BitSet skipped = new BitSet();
  private final BitSet good = new BitSet();

  /**
   * Begins a search.
   *
   * @param parents the parents of each commit within the history, which have lower numbers
   * @throws IllegalArgumentException if there is no commit, or a parent does not precede its child
   */
  public Bisection(List<List<Integer>> parents) {
    if (parents.isEmpty()) {
      throw new IllegalArgumentException("the history has no commit");
    }
    closures = new ArrayList<>(parents.size());
    for (int i = 0; i < parents.size(); i++) {
      BitSet closure = new BitSet();
      closure.set(i);
      for (int parent : parents.get(i)) {
        if (parent < 0 || parent >= i) {
          throw new IllegalArgumentException("commit " + i + " has the parent " + parent);
        }
        closure.or(closures.get(parent));
      }
      closures.add(closure);
    }
    int last = parents.size() - 1;
    candidates = (BitSet) closures.get(last).clone();
    tested.set(last);
  }

  /** The commit to test next; empty if no further test helps. */
  public OptionalInt next() {
    int best = -1;
    int bestScore = 0;
    int total = candidates.cardinality();
    for (int i = candidates.nextSetBit(0); i >= 0; i = candidates.nextSetBit(i + 1)) {
      if (tested.get(i)) {
        continue;
      }
      int below = below(i);
      int score = Math.min(below, total - below);
      // Neighbours of a commit that does not compile often do not compile, either.
      if (isNearSkipped(i, total)) {
        score = (score + 1) / 2;
      }
      if (score > bestScore) {
        best = i;
        bestScore = score;
      }
    }
    return best < 0 ? OptionalInt.empty() : OptionalInt.of(best);
  }

  /** The number of candidates that a good test of a commit excludes. */
  private int below(int commit) {
    BitSet closure = (BitSet) closures.get(commit).clone();
    closure.and(candidates);
    return closure.cardinality();
  }

  private boolean isNearSkipped(int commit, int total) {
    int distance = Math.max(1, total / AWAY);
    int next = skipped.nextSetBit(Math.max(0, commit - distance));
    return next >= 0 && next <= commit + distance;
  }

  /**
   * Records the test of a commit.
   *
   * @throws IllegalArgumentException if the commit is not in the history
   */
  public void record(int commit, Outcome outcome) {
    if (commit < 0 || commit >= closures.size()) {
      throw new IllegalArgumentException("no commit " + commit);
    }
    tested.set(commit);
    switch (outcome) {
      case GOOD -> {
        good.set(commit);
        candidates.andNot(closures.get(commit));
      }
      case BAD -> candidates.and(closures.get(commit));
      case SKIPPED -> skipped.set(commit);
    }
  }

  /**
   * The commits of which one is the first bad one, in their order: a single one unless others could
   * not be tested.
   */
  public List<Integer> candidates() {
    return candidates.stream().boxed().toList();
  }

  /** Whether some tested commit is good. */
  public boolean hasGood() {
    return !good.isEmpty();
  }
}
