package org.sitaf.core.timing;

import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.hipparchus.distribution.discrete.BinomialDistribution;
import org.jspecify.annotations.Nullable;

/**
 * The measured repetitions of the call of a case. All times are in microseconds and of the
 * component itself, without virtual hardware and stubs.
 *
 * @param warmUp calls before the measured ones
 * @param calls number of measured calls; fewer than ordered if their time was used up
 * @param median null without calls
 * @param low lower end of the 95 % interval of the median; null with fewer than {@link
 *     #MIN_FOR_INTERVAL} calls
 * @param high upper end of the 95 % interval of the median; null like {@code low}
 * @param samples times of at most {@link #MAX_SAMPLES} of the calls, in their order
 * @param differs how the first call that gave something else than the judged one differs from it;
 *     empty if all calls gave the same
 */
public record RepeatedCalls(
    int warmUp,
    int calls,
    @Nullable Double median,
    @Nullable Double low,
    @Nullable Double high,
    List<Double> samples,
    String differs) {
  /** Enough for a comparison; evenly spaced ones of more calls are kept. */
  public static final int MAX_SAMPLES = 100;

  /** With five calls, even the smallest and the largest time enclose the median in 94 % only. */
  public static final int MIN_FOR_INTERVAL = 6;

  private static final int MAX_TEXT = 1000;
  private static final double OUTSIDE_ON_ONE_SIDE = 0.025;
  private static final double NANOS_IN_MICRO = 1000;

  public RepeatedCalls {
    if (warmUp < 0 || warmUp > Timing.MAX_WARM_UP || calls < 0 || calls > Timing.MAX_REPEAT) {
      throw new IllegalArgumentException("repeated_calls must have possible numbers of calls");
    }
    if (samples.size() != Math.min(calls, MAX_SAMPLES) || (median == null) != (calls == 0)) {
      throw new IllegalArgumentException(
          "repeated_calls must have a median and the times of up to " + MAX_SAMPLES + " calls");
    }
    if ((low == null) != (high == null)) {
      throw new IllegalArgumentException("repeated_calls must have both ends of the interval");
    }
    requireTime(median);
    requireTime(low);
    requireTime(high);
    samples.forEach(RepeatedCalls::requireTime);
    samples = List.copyOf(samples);
    Objects.requireNonNull(differs);
    differs = differs.length() <= MAX_TEXT ? differs : differs.substring(0, MAX_TEXT) + "…";
  }

  private static void requireTime(@Nullable Double micros) {
    if (micros != null && !(micros >= 0 && micros < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("repeated_calls must have times that are not negative");
    }
  }

  /**
   * The statistics of measured calls.
   *
   * @param nanos the time of each call, in the order of the calls
   */
  public static RepeatedCalls of(int warmUp, long[] nanos, String differs) {
    double[] sorted = LongStream.of(nanos).sorted().mapToDouble(n -> n / NANOS_IN_MICRO).toArray();
    int n = sorted.length;
    int below = n < MIN_FOR_INTERVAL ? -1 : callsBelowInterval(n);
    int kept = Math.min(n, MAX_SAMPLES);
    return new RepeatedCalls(
        warmUp,
        n,
        n == 0 ? null : (sorted[(n - 1) / 2] + sorted[n / 2]) / 2,
        below < 0 ? null : sorted[below],
        below < 0 ? null : sorted[n - 1 - below],
        IntStream.range(0, kept)
            .mapToObj(i -> nanos[(int) ((long) i * n / kept)] / NANOS_IN_MICRO)
            .toList(),
        differs);
  }

  /**
   * The number of times below the interval of the median, and above it, by order statistics: the
   * number of times below the true median is binomially distributed, whatever the distribution of
   * the times.
   */
  private static int callsBelowInterval(int calls) {
    BinomialDistribution belowMedian = new BinomialDistribution(calls, 0.5);
    int below = 0;
    while (belowMedian.cumulativeProbability(below + 1) <= OUTSIDE_ON_ONE_SIDE) {
      below++;
    }
    return below;
  }

  /** Whether a repeated call gave something else than the judged call. */
  public boolean differ() {
    return !differs.isEmpty();
  }

  double[] times() {
    return samples.stream().mapToDouble(Double::doubleValue).toArray();
  }
}
