package org.sitaf.core.sequence;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.sequence.array.SequenceCovering;
import org.sitaf.core.sequence.array.Subsequences;
import org.sitaf.core.sequence.array.TupleSpace;

/**
 * Finds words of steps that a machine can execute and that contain every allowed tuple as a
 * subsequence: few words first, then few steps.
 */
public final class CoveringWords {
  /** Maximum number of places of all searches for one word without repetition. */
  private static final long MAX_EXPLORED = 20_000_000;

  /** Maximum number of tuples in one word for which words are exchanged and shortened. */
  private static final double MAX_IN_WORD = 300_000;

  private final Machine machine;
  private final TupleSpace space;
  private final int length;
  private final boolean repeat;
  private final WordPlan plan;

  /**
   * Prepares a search.
   *
   * @param length maximum number of steps of a word
   * @param repeat whether a word may contain a step several times
   */
  public CoveringWords(Machine machine, TupleSpace space, int length, boolean repeat) {
    this.machine = machine;
    this.space = space;
    this.length = length;
    this.repeat = repeat;
    this.plan = new WordPlan(machine, repeat, MAX_EXPLORED);
  }

  /**
   * The tuples that some executable word contains.
   *
   * @throws IllegalStateException if there are too many possibilities, with numbers
   */
  public BitSet allowed() {
    BitSet allowed = AllowedTuples.of(machine, space, length);
    if (repeat) {
      return allowed;
    }
    boolean free = machine.isFree();
    for (int t = allowed.nextSetBit(0); t >= 0; t = allowed.nextSetBit(t + 1)) {
      if (!space.isDistinct(t) || (!free && shortest(space.letters(t)) == null)) {
        allowed.clear(t);
      }
    }
    return allowed;
  }

  /** A shortest executable word that contains a tuple of any length; null if there is none. */
  public int @org.jspecify.annotations.Nullable [] shortest(int[] tuple) {
    return plan.shortest(machine.initial(), new BitSet(), tuple, length)
        .map(path -> path.stream().mapToInt(Integer::intValue).toArray())
        .orElse(null);
  }

  /**
   * Words that contain all required tuples, each of which must be allowed. The same arguments give
   * the same words.
   *
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public List<int[]> cover(BitSet required, Effort effort, long seed, Progress progress) {
    if (required.isEmpty()) {
      return List.of();
    }
    SequenceCovering search = new SequenceCovering(space, effort, seed, progress);
    boolean free = machine.isFree();
    if (free && !repeat && length >= space.letters()) {
      return shortened(search.permutations(), required);
    }
    WordBuilder builder = new WordBuilder(machine, space, plan, required, length, repeat, seed);
    List<int[]> words = new ArrayList<>();
    while (!builder.isDone()) {
      Interruption.check();
      words.add(builder.next());
      progress.report(words.size(), 0);
    }
    words = shortened(withoutSuperfluous(words, required), required);
    if (inWord() <= MAX_IN_WORD) {
      boolean all = free && repeat && required.cardinality() == space.size();
      words =
          all
              ? search.reduceFree(words, length)
              : compact(search.reduce(words, length, required, this::isPossible));
      // The search may end with a word that the others do not need.
      words = withoutSuperfluous(words, required);
    }
    return shortened(words, required);
  }

  /** Removes the tuples that a word contains. */
  public static void remove(BitSet tuples, TupleSpace space, int[] word) {
    Subsequences.forEach(word, space.letters(), space.strength(), tuples::clear);
  }

  /** Whether the machine executes a word, empty places left out. */
  private boolean isPossible(int[] word) {
    if (!repeat) {
      BitSet used = new BitSet();
      for (int kind : word) {
        if (kind >= 0 && used.get(kind)) {
          return false;
        }
        if (kind >= 0) {
          used.set(kind);
        }
      }
    }
    return machine.executes(word);
  }

  private double inWord() {
    double tuples = 1;
    for (int i = 0; i < space.strength(); i++) {
      tuples *= (double) (length - i) / (i + 1);
    }
    return tuples;
  }

  private static List<int[]> compact(List<int[]> words) {
    return words.stream().map(w -> Arrays.stream(w).filter(k -> k >= 0).toArray()).toList();
  }

  /** Leaves out words whose tuples are all in other words. */
  private List<int[]> withoutSuperfluous(List<int[]> words, BitSet required) {
    List<int[]> kept = new ArrayList<>(words);
    if (inWord() > MAX_IN_WORD) {
      return kept;
    }
    TupleCount count = new TupleCount(space, required);
    kept.forEach(count::add);
    for (int w = kept.size() - 1; w >= 0; w--) {
      count.remove(kept.get(w));
      if (count.isComplete()) {
        kept.remove(w);
      } else {
        count.add(kept.get(w));
      }
    }
    return kept;
  }

  /** Leaves out steps that are not needed. */
  private List<int[]> shortened(List<int[]> words, BitSet required) {
    if (inWord() > MAX_IN_WORD) {
      return words;
    }
    TupleCount count = new TupleCount(space, required);
    words.forEach(count::add);
    List<int[]> shorter = new ArrayList<>();
    for (int[] word : words) {
      Interruption.check();
      int[] current = word;
      count.remove(current);
      for (int p = current.length - 1; p >= 0 && current.length > 1; p--) {
        int[] without = new int[current.length - 1];
        System.arraycopy(current, 0, without, 0, p);
        System.arraycopy(current, p + 1, without, p, without.length - p);
        if (machine.executes(without)) {
          count.add(without);
          if (count.isComplete()) {
            current = without;
          }
          count.remove(without);
        }
      }
      count.add(current);
      shorter.add(current);
    }
    return shorter;
  }
}
