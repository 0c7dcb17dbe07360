package org.sitaf.core.trajectory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class TraceReductionTest {
  private static final long STEP = 1_000_000;

  private static Trace trace(long first, double[]... columns) {
    List<String> names = List.of("a", "b", "c").subList(0, columns.length);
    return new Trace(first, STEP, names, List.of(columns));
  }

  @Test
  void aShortTraceIsComplete() {
    assertThat(TraceReduction.samples(trace(0, new double[10]), 12, List.of()))
        .containsExactly(0, 1, 2, 3, 4, 5, 6, 7, 8, 9);
  }

  @Property(tries = 50)
  void peaksEndsAndGivenTimesRemain(
      @ForAll @IntRange(min = 1000, max = 5000) int count,
      @ForAll @IntRange(min = 0, max = 999) int peak,
      @ForAll @IntRange(min = 0, max = 999) int given) {
    double[] peaks = new double[count];
    peaks[peak] = 1;
    double[] rising = new double[count];
    Arrays.setAll(rising, k -> k);

    int[] samples =
        TraceReduction.samples(
            trace(-20 * STEP, peaks, rising), 100, List.of((given - 20) * STEP, Long.MAX_VALUE));

    assertThat(samples).isSorted().doesNotHaveDuplicates().hasSizeLessThanOrEqualTo(102);
    assertThat(samples).contains(0, count - 1, peak, given);
    assertThat(samples).hasSizeGreaterThan(25);
  }

  @Test
  void numbersThatAreNoNumbersRemain() {
    double[] values = new double[500];
    values[77] = Double.NaN;
    values[300] = Double.NEGATIVE_INFINITY;

    assertThat(TraceReduction.samples(trace(0, values), 20, List.of())).contains(77, 300);
  }

  @Test
  void aLimitBelowTheNumberOfSignalsIsRejected() {
    assertThatThrownBy(() -> TraceReduction.samples(trace(0, new double[5]), 7, List.of()))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
