package org.sitaf.core.bisect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.sitaf.core.bisect.Bisection.Outcome;

class BisectionTest {
  private static List<List<Integer>> line(int length) {
    List<List<Integer>> parents = new ArrayList<>();
    for (int i = 0; i < length; i++) {
      parents.add(i == 0 ? List.of() : List.of(i - 1));
    }
    return parents;
  }

  private static int search(Bisection bisection, BitSet bad, Set<Integer> broken) {
    int tests = 0;
    for (OptionalInt next = bisection.next(); next.isPresent(); next = bisection.next()) {
      int commit = next.getAsInt();
      tests++;
      bisection.record(
          commit,
          broken.contains(commit) ? Outcome.SKIPPED : bad.get(commit) ? Outcome.BAD : Outcome.GOOD);
    }
    return tests;
  }

  @Property
  void findsTheFirstBadOfSixtyFourCommitsInSixTests(@ForAll @IntRange(max = 63) int first) {
    Bisection bisection = new Bisection(line(64));
    BitSet bad = new BitSet();
    bad.set(first, 64);

    assertThat(search(bisection, bad, Set.of())).isLessThanOrEqualTo(6);
    assertThat(bisection.candidates()).containsExactly(first);
    assertThat(bisection.hasGood()).isEqualTo(first > 0);
  }

  @Property
  void needsThreeMoreTestsAtMostIfThreeNeighboursCannotBeTested(
      @ForAll @IntRange(max = 63) int first, @ForAll @IntRange(max = 60) int broken) {
    Bisection bisection = new Bisection(line(64));
    BitSet bad = new BitSet();
    bad.set(first, 64);
    Set<Integer> untestable = Set.of(broken, broken + 1, broken + 2);
    Assume.that(!untestable.contains(first));

    assertThat(search(bisection, bad, untestable)).isLessThanOrEqualTo(9);
    assertThat(bisection.candidates()).contains(first);
    assertThat(bisection.candidates()).allMatch(c -> c == first || untestable.contains(c));
  }

  /** A bad commit makes everything that is based on it bad. */
  @Property
  void findsTheFirstBadCommitOfAHistoryWithMerges(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 40) int length) {
    Random random = new Random(seed);
    List<List<Integer>> parents = new ArrayList<>();
    for (int i = 0; i < length; i++) {
      List<Integer> some = new ArrayList<>();
      for (int k = 0; i > 0 && k < 2; k++) {
        int parent = Math.max(0, i - 1 - random.nextInt(4));
        if (!some.contains(parent)) {
          some.add(parent);
        }
      }
      parents.add(some);
    }
    int last = length - 1;
    List<Integer> reachable = new ArrayList<>(new Bisection(parents).candidates());
    int first = reachable.get(random.nextInt(reachable.size()));
    BitSet bad = new BitSet();
    for (int i = 0; i < length; i++) {
      int commit = i;
      if (commit == first || parents.get(commit).stream().anyMatch(bad::get)) {
        bad.set(commit);
      }
    }
    assertThat(bad.get(last)).isTrue();

    Bisection bisection = new Bisection(parents);
    search(bisection, bad, Set.of());
    assertThat(bisection.candidates()).containsExactly(first);
  }

  @Test
  void rejectsHistoriesThatAreNotOrdered() {
    assertThatThrownBy(() -> new Bisection(List.of())).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Bisection(List.of(List.of(0))))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
