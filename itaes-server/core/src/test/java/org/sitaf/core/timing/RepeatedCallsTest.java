package org.sitaf.core.timing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class RepeatedCallsTest {
  private static RepeatedCalls of(long... nanos) {
    return RepeatedCalls.of(3, nanos, "");
  }

  @Test
  void theIntervalIsThatOfTheTablesOfTheSignTest() {
    // Conover, Practical Nonparametric Statistics: ranks 6 and 15 of 20, 4 and 12 of 15, 1 and 6 of
    // 6.
    RepeatedCalls twenty = of(LongStream.rangeClosed(1, 20).map(n -> n * 1000).toArray());
    assertThat(List.of(twenty.median(), twenty.low(), twenty.high()))
        .isEqualTo(List.of(10.5, 6.0, 15.0));
    RepeatedCalls fifteen = of(LongStream.rangeClosed(1, 15).map(n -> n * 1000).toArray());
    assertThat(List.of(fifteen.median(), fifteen.low(), fifteen.high()))
        .isEqualTo(List.of(8.0, 4.0, 12.0));
    RepeatedCalls six = of(6000, 5000, 4000, 3000, 2000, 1000);
    assertThat(List.of(six.median(), six.low(), six.high())).isEqualTo(List.of(3.5, 1.0, 6.0));
  }

  @Test
  void fewCallsHaveNoInterval() {
    assertThat(of(1000, 2000, 3000, 4000, 9000).low()).isNull();
    assertThat(of(1000).median()).isEqualTo(1.0);
    assertThat(of().median()).isNull();
  }

  @Test
  void theIntervalContainsTheTrueMedianAsOftenAsItSays() {
    Random random = new Random(7);
    int runs = 2000;
    int contained = 0;
    for (int run = 0; run < runs; run++) {
      // Skewed like times; the true median is 5000 * ln 2.
      long[] nanos =
          LongStream.range(0, 20)
              .map(i -> Math.round(-5000 * Math.log(1 - random.nextDouble())))
              .toArray();
      RepeatedCalls calls = of(nanos);
      double median = 5 * Math.log(2);
      contained += calls.low() <= median && median <= calls.high() ? 1 : 0;
    }
    assertThat(contained / (double) runs).isBetween(0.95, 0.98);
  }

  @Property(tries = 200)
  void keepsAtMostAHundredSamplesOfAllCalls(
      @ForAll @Size(min = 1, max = 500) List<@LongRange(min = 0, max = 1_000_000_000) Long> given) {
    long[] nanos = given.stream().mapToLong(Long::longValue).toArray();
    RepeatedCalls calls = of(nanos);
    assertThat(calls.calls()).isEqualTo(nanos.length);
    assertThat(calls.samples()).hasSize(Math.min(100, nanos.length));
    assertThat(Arrays.stream(nanos).mapToObj(n -> n / 1000.0).toList())
        .containsAll(calls.samples());
    if (calls.low() != null) {
      assertThat(calls.median()).isBetween(calls.low(), calls.high());
    }
  }

  @Test
  void contradictoryNumbersAreRejected() {
    assertThatThrownBy(() -> new RepeatedCalls(3, 2, 1.0, null, null, List.of(1.0), ""))
        .hasMessageContaining("the times of up to 100 calls");
    assertThatThrownBy(() -> new RepeatedCalls(3, 1, Double.NaN, null, null, List.of(1.0), ""))
        .hasMessageContaining("not negative");
    assertThatThrownBy(() -> new RepeatedCalls(3, 1, 1.0, 1.0, null, List.of(1.0), ""))
        .hasMessageContaining("both ends");
    assertThatThrownBy(() -> new RepeatedCalls(-1, 0, null, null, null, List.of(), ""))
        .hasMessageContaining("possible numbers");
    assertThat(RepeatedCalls.of(0, new long[0], "x".repeat(5000)).differs()).hasSize(1001);
  }
}
