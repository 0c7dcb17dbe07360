package org.sitaf.core.sequence;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.sequence.array.TupleSpace;

/**
 * Builds words one after another. Each step is the one from which most uncovered tuples can be
 * expected to be completed, as in density algorithms for covering arrays (Bryce, Colbourn, 2007),
 * among those that leave one chosen uncovered tuple possible.
 */
final class WordBuilder {
  /** How many uncovered tuples are tried as the next one to complete. */
  private static final int CANDIDATES = 12;

  private final Machine machine;
  private final TupleSpace space;
  private final WordPlan plan;
  private final BitSet uncovered;
  private final int length;
  private final boolean repeat;
  private final SeededRandom random;
  private final int strength;

  /** For each length of a beginning, how many uncovered tuples begin with it. */
  private final int[][] beginning;

  WordBuilder(
      Machine machine,
      TupleSpace space,
      WordPlan plan,
      BitSet required,
      int length,
      boolean repeat,
      long seed) {
    this.machine = machine;
    this.space = space;
    this.plan = plan;
    this.uncovered = (BitSet) required.clone();
    this.length = length;
    this.repeat = repeat;
    this.random = new SeededRandom(seed);
    this.strength = space.strength();
    this.beginning = new int[strength + 1][];
    int size = 1;
    for (int i = 0; i <= strength; i++) {
      beginning[i] = new int[size];
      size *= space.letters();
    }
    for (int t = uncovered.nextSetBit(0); t >= 0; t = uncovered.nextSetBit(t + 1)) {
      count(t, 1);
    }
  }

  private void count(int tuple, int change) {
    int rest = tuple;
    for (int i = strength; i >= 0; i--) {
      beginning[i][rest] += change;
      rest /= space.letters();
    }
  }

  /** Whether every required tuple is in a word. */
  boolean isDone() {
    return uncovered.isEmpty();
  }

  /** The word under construction. */
  private final class Word {
    private final List<Integer> kinds = new ArrayList<>();
    private final BitSet used = new BitSet();
    private BitSet states = machine.initial();

    /** For each length, the beginnings of tuples that the word contains. */
    private final List<BitSet> contained = new ArrayList<>();

    Word() {
      for (int i = 0; i <= strength; i++) {
        contained.add(new BitSet());
      }
      contained.get(0).set(0);
    }

    void append(int kind) {
      kinds.add(kind);
      used.set(kind);
      states = machine.after(states, kind);
      for (int i = strength; i >= 1; i--) {
        BitSet shorter = contained.get(i - 1);
        for (int b = shorter.nextSetBit(0); b >= 0; b = shorter.nextSetBit(b + 1)) {
          contained.get(i).set(b * space.letters() + kind);
        }
      }
    }

    /** The number of uncovered tuples that can be expected from appending a step. */
    double gain(int kind) {
      int left = length - kinds.size() - 1;
      double gain = 0;
      for (int i = 1; i <= strength; i++) {
        double chance = chance(left, strength - i);
        if (chance == 0) {
          continue;
        }
        BitSet shorter = contained.get(i - 1);
        long sum = 0;
        for (int b = shorter.nextSetBit(0); b >= 0; b = shorter.nextSetBit(b + 1)) {
          int longer = b * space.letters() + kind;
          if (beginning[i][longer] > 0 && !contained.get(i).get(longer)) {
            sum += beginning[i][longer];
          }
        }
        gain += chance * sum;
      }
      return gain;
    }

    /** The chance that given further letters follow in the remaining places. */
    private double chance(int left, int letters) {
      double chance = 1;
      for (int i = 0; i < letters; i++) {
        chance *= (double) (left - i) / (i + 1) / space.letters();
      }
      return Math.max(0, Math.min(1, chance));
    }
  }

  /** The next word, which covers at least one uncovered tuple. */
  int[] next() {
    Word word = new Word();
    int[] rest = target(word);
    int done = 0;
    while (word.kinds.size() < length && rest.length > 0) {
      int kind = best(word, rest);
      word.append(kind);
      if (rest[0] == kind) {
        rest = java.util.Arrays.copyOfRange(rest, 1, rest.length);
      }
      if (rest.length == 0) {
        done = word.kinds.size();
        rest = target(word);
      }
    }
    int[] built = word.kinds.subList(0, done).stream().mapToInt(Integer::intValue).toArray();
    cover(built);
    return built;
  }

  /** Removes the tuples of a word from the uncovered ones. */
  void cover(int[] built) {
    Word word = new Word();
    for (int kind : built) {
      word.append(kind);
    }
    BitSet contained = word.contained.get(strength);
    for (int t = contained.nextSetBit(0); t >= 0; t = contained.nextSetBit(t + 1)) {
      if (uncovered.get(t)) {
        uncovered.clear(t);
        count(t, -1);
      }
    }
  }

  /** What remains of an uncovered tuple that needs few further steps; empty if none fits. */
  private int[] target(Word word) {
    int most = length - word.kinds.size();
    int[] best = new int[0];
    int least = Integer.MAX_VALUE;
    boolean first = word.kinds.isEmpty();
    BitSet whole = word.contained.get(strength);
    int tried = 0;
    int start = random.nextInt(space.size());
    for (int i = 0; i < 2 && tried < CANDIDATES; i++) {
      int from = i == 0 ? start : 0;
      int to = i == 0 ? space.size() : start;
      for (int t = uncovered.nextSetBit(from);
          t >= 0 && t < to && tried < CANDIDATES;
          t = uncovered.nextSetBit(t + 1)) {
        if (whole.get(t)) {
          continue;
        }
        tried++;
        int[] rest = rest(word, t);
        if (rest.length > most) {
          continue;
        }
        Optional<List<Integer>> path = plan.shortest(word.states, word.used, rest, most);
        if (path.isPresent() && path.get().size() < least) {
          least = path.get().size();
          best = rest;
          if (first) {
            return best;
          }
        }
      }
    }
    return best;
  }

  private int[] rest(Word word, int tuple) {
    int[] letters = space.letters(tuple);
    int matched = 0;
    for (int kind : word.kinds) {
      if (matched < letters.length && letters[matched] == kind) {
        matched++;
      }
    }
    return java.util.Arrays.copyOfRange(letters, matched, letters.length);
  }

  /** The step with the largest gain among those that leave the rest of a tuple possible. */
  private int best(Word word, int[] rest) {
    int most = length - word.kinds.size();
    List<Integer> path = plan.shortest(word.states, word.used, rest, most).orElseThrow();
    int best = path.get(0);
    double largest = word.gain(best);
    if (path.size() == most) {
      return best;
    }
    for (int kind = 0; kind < machine.kinds(); kind++) {
      if (kind == path.get(0) || (!repeat && word.used.get(kind))) {
        continue;
      }
      BitSet after = machine.after(word.states, kind);
      if (after.isEmpty()) {
        continue;
      }
      double gain = word.gain(kind);
      if (gain <= largest) {
        continue;
      }
      BitSet used = (BitSet) word.used.clone();
      used.set(kind);
      int[] left = rest[0] == kind ? java.util.Arrays.copyOfRange(rest, 1, rest.length) : rest;
      if (plan.shortest(after, used, left, most - 1).isPresent()) {
        best = kind;
        largest = gain;
      }
    }
    return best;
  }
}
