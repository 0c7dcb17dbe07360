package org.sitaf.core.timing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.sitaf.core.timing.TimeComparison.Change;
import org.sitaf.core.timing.TimeComparison.Pair;

class TimeComparisonTest {
  private final Random random = new Random(11);

  /** Skewed times above a minimum, as they are measured. */
  private RepeatedCalls calls(double micros) {
    return RepeatedCalls.of(
        3,
        LongStream.range(0, 20)
            .map(i -> Math.round(micros * 1000 * (1 + 0.05 * -Math.log(1 - random.nextDouble()))))
            .toArray(),
        "");
  }

  @Test
  void aCaseThatTakesHalfAsLongAgainIsSlower() {
    Change change = TimeComparison.of(List.of(new Pair(calls(4), calls(6)))).get(0);
    assertThat(change.slower()).isTrue();
    assertThat(change.ratio()).isEqualTo(1.5, within(0.1));
    // wilcox.test of R for 20 values that are all smaller than 20 others.
    assertThat(change.p()).isEqualTo(6.8e-8, within(1e-9));
  }

  @Test
  void aSignificantDifferenceBelowTenPercentIsNotSlower() {
    assertThat(TimeComparison.of(List.of(new Pair(calls(100), calls(107)))).get(0).slower())
        .isFalse();
  }

  @Test
  void oneSampleIsNoEvidence() {
    RepeatedCalls before = RepeatedCalls.of(0, new long[] {4000}, "");
    RepeatedCalls now = RepeatedCalls.of(0, new long[] {370_000}, "");
    Change change = TimeComparison.of(List.of(new Pair(before, now))).get(0);
    assertThat(change.ratio()).isEqualTo(92.5);
    assertThat(change.slower()).isFalse();
  }

  @Test
  void noneOfManyEqualCasesIsSlower() {
    List<Pair> pairs = IntStream.range(0, 2000).mapToObj(i -> new Pair(wide(), wide())).toList();
    List<Change> changes = TimeComparison.of(pairs);
    assertThat(changes).hasSize(2000).noneMatch(Change::slower);
    assertThat(changes).anyMatch(c -> c.ratio() >= TimeComparison.MIN_RATIO);
  }

  private RepeatedCalls wide() {
    return RepeatedCalls.of(
        3, LongStream.range(0, 20).map(i -> 1000 + random.nextInt(3000)).toArray(), "");
  }

  @Test
  void equalTimesAreNotSlower() {
    RepeatedCalls none = RepeatedCalls.of(3, new long[20], "");
    assertThat(TimeComparison.of(Collections.nCopies(3, new Pair(none, none))))
        .containsOnly(new Change(1, 1));
  }

  @Test
  void adjustsAsHolmDescribes() {
    assertThat(TimeComparison.adjusted(new double[] {0.04, 0.01, 0.03, 0.005}))
        .containsExactly(new double[] {0.06, 0.03, 0.06, 0.02}, within(1e-12));
  }
}
