package org.sitaf.core.timing;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.hipparchus.stat.inference.MannWhitneyUTest;

/**
 * Compares the times of cases between two results. A case is slower if the median of its repeated
 * calls grew by at least 10 % and the Mann-Whitney U test finds a difference. The p-values are
 * adjusted for the number of compared cases (Holm, 1979), so that one comparison of many cases
 * finds a difference by chance as rarely as that of a single case.
 */
public final class TimeComparison {
  /** The smallest ratio of medians that counts. */
  public static final double MIN_RATIO = 1.1;

  /** The largest adjusted p-value that counts. */
  public static final double MAX_P = 0.05;

  /** Clocks have a resolution of a nanosecond at best. */
  private static final double RESOLUTION_US = 0.001;

  private TimeComparison() {}

  /** The repeated calls of one case in both results; each has at least one call. */
  public record Pair(RepeatedCalls before, RepeatedCalls now) {
    public Pair {
      if (before.calls() == 0 || now.calls() == 0) {
        throw new IllegalArgumentException("a comparison needs times");
      }
    }

    private double ratio() {
      return Math.max(Objects.requireNonNull(now.median()), RESOLUTION_US)
          / Math.max(Objects.requireNonNull(before.median()), RESOLUTION_US);
    }
  }

  /**
   * How the times of a case changed.
   *
   * @param ratio the median now divided by the median before
   * @param p adjusted p-value of the Mann-Whitney U test; 1 if the ratio is too small to be tested
   */
  public record Change(double ratio, double p) {
    /** Whether the case is slower now. */
    public boolean slower() {
      return ratio >= MIN_RATIO && p <= MAX_P;
    }
  }

  /** Compares the cases of two results; the changes have the order of the pairs. */
  public static List<Change> of(List<Pair> pairs) {
    MannWhitneyUTest test = new MannWhitneyUTest();
    double[] p = new double[pairs.size()];
    for (int i = 0; i < p.length; i++) {
      Pair pair = pairs.get(i);
      p[i] = pair.ratio() < MIN_RATIO ? 1 : p(test, pair);
    }
    double[] adjusted = adjusted(p);
    List<Change> changes = new ArrayList<>();
    for (int i = 0; i < p.length; i++) {
      changes.add(new Change(pairs.get(i).ratio(), adjusted[i]));
    }
    return changes;
  }

  /**
   * The p-value by the normal approximation, which corrects for ties and differs little from the
   * exact one for four calls and more. The exact test takes milliseconds for a case.
   */
  private static double p(MannWhitneyUTest test, Pair pair) {
    return Math.min(1, test.mannWhitneyUTest(pair.before().times(), pair.now().times(), false));
  }

  /** Holm's step-down adjustment. */
  static double[] adjusted(double[] p) {
    List<Integer> ascending =
        IntStream.range(0, p.length).boxed().sorted(Comparator.comparingDouble(i -> p[i])).toList();
    double[] adjusted = new double[p.length];
    double largest = 0;
    for (int rank = 0; rank < p.length; rank++) {
      int i = ascending.get(rank);
      largest = Math.max(largest, Math.min(1, (p.length - rank) * p[i]));
      adjusted[i] = largest;
    }
    return adjusted;
  }
}
