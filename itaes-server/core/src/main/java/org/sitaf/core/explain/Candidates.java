package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * The sets of parameters of one failing row whose values may be the cause of its failure, with
 * their probabilities. A set is excluded if a row with these values passed. The others are weighted
 * as in Bayes' theorem: by their size, and by the failing rows that they would explain.
 */
final class Candidates {
  /** Causes of more parameters are rare (Kuhn et al., 2004). */
  private static final double[] PRIOR = {0.01, 0.33, 0.36, 0.24, 0.04, 0.01, 0.005};

  private static final double PRIOR_OF_LARGE = 0.001;

  /** Probability that the same cause gives another message. */
  private static final double OTHER_KIND = 0.12;

  /** Probability that a row beyond the suite fails by a cause that is not known. */
  private static final double OTHER_CAUSE = 0.04;

  /** Larger sets are listed only if no smaller one is left. */
  private static final int MAX_LISTED = 20_000;

  private final int[] row;
  private final long[] masks;
  private final double[] weights;
  private final double total;

  private Candidates(int[] row, long[] masks, double[] weights) {
    this.row = row;
    this.masks = masks;
    this.weights = weights;
    double sum = 0;
    for (double weight : weights) {
      sum += weight;
    }
    this.total = sum;
  }

  /**
   * The candidates of a row.
   *
   * @param free the parameters with more than one value
   * @param unexplained the failing rows without a known cause
   * @param suite the failing rows of the suite
   * @param rate share of the rows of the suite that fail
   */
  static Candidates of(
      Combinations.Row failed,
      long free,
      History history,
      List<Combinations.Row> unexplained,
      Set<Combinations.Row> suite,
      double rate) {
    int[] row = failed.values();
    List<Exclusion> agreements = exclusions(row, free, history);
    List<Long> masks = new ArrayList<>();
    int count = Long.bitCount(free);
    if (agreements.stream().noneMatch(e -> e.required() == 0)) {
      masks.add(0L);
    }
    for (int size = 1; size <= count; size++) {
      if (combinations(count, size) + masks.size() > MAX_LISTED && size > 2) {
        break;
      }
      // Sets of five and more only if smaller ones do not suffice.
      if (size > 4 && !masks.isEmpty()) {
        break;
      }
      list(free, size, agreements, masks);
    }
    double[] weights = new double[masks.size()];
    for (int i = 0; i < weights.length; i++) {
      weights[i] = prior(Long.bitCount(masks.get(i)), count);
    }
    for (Combinations.Row other : unexplained) {
      if (other != failed) {
        long agreement = History.agreement(other.values(), row) & free;
        boolean same = other.outcome().kind().equals(failed.outcome().kind());
        double chance = suite.contains(other) ? rate : OTHER_CAUSE;
        double factor = (same ? 1 - OTHER_KIND : OTHER_KIND) / (chance * 0.5);
        for (int i = 0; i < weights.length; i++) {
          if ((masks.get(i) & ~agreement) == 0) {
            weights[i] *= Math.max(1, factor);
          }
        }
      }
    }
    return new Candidates(row, masks.stream().mapToLong(Long::longValue).toArray(), weights);
  }

  /** The probability of a set before any execution; of few parameters, larger sets have no more. */
  private static double prior(int size, int count) {
    double share =
        (size < PRIOR.length ? PRIOR[size] : PRIOR_OF_LARGE)
            / Math.max(1, combinations(count, size));
    return size > 1 ? Math.min(share, prior(size - 1, count)) : share;
  }

  private static double combinations(int n, int k) {
    double result = 1;
    for (int i = 1; i <= k; i++) {
      result = result * (n - k + i) / i;
    }
    return result;
  }

  /** The largest sets of parameters in which passing rows agree with the failing one. */
  private static List<Exclusion> exclusions(int[] row, long free, History history) {
    List<Exclusion> kept = new ArrayList<>();
    for (int[] passed : history.passing()) {
      long agreement = History.agreement(passed, row) & free;
      long required = history.combinations().invalidOf(passed) & free;
      if ((required & ~agreement) != 0) {
        continue;
      }
      if (!isCovered(kept, agreement, required)) {
        Exclusion added = new Exclusion(agreement, required);
        kept.removeIf(added::covers);
        kept.add(added);
      }
    }
    return kept;
  }

  private static boolean isCovered(List<Exclusion> kept, long agreement, long required) {
    for (Exclusion exclusion : kept) {
      if (exclusion.covers(agreement, required)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Sets of parameters that are no cause.
   *
   * @param agreement contains them
   * @param required is in each of them
   */
  private record Exclusion(long agreement, long required) {
    boolean covers(Exclusion other) {
      return covers(other.agreement, other.required);
    }

    boolean covers(long others, long requiredOfOthers) {
      return required == requiredOfOthers && (others & ~agreement) == 0;
    }

    boolean excludes(long mask) {
      return (mask & ~agreement) == 0 && (required & ~mask) == 0;
    }
  }

  private static void list(long free, int size, List<Exclusion> agreements, List<Long> masks) {
    int[] positions = new int[Long.bitCount(free)];
    long left = free;
    for (int i = 0; i < positions.length; i++) {
      positions[i] = Long.numberOfTrailingZeros(left);
      left &= left - 1;
    }
    int[] chosen = new int[size];
    for (int i = 0; i < size; i++) {
      chosen[i] = i;
    }
    while (true) {
      long mask = 0;
      for (int c : chosen) {
        mask |= 1L << positions[c];
      }
      if (isPossible(mask, agreements)) {
        masks.add(mask);
      }
      int i = size - 1;
      while (i >= 0 && chosen[i] == positions.length - size + i) {
        i--;
      }
      if (i < 0) {
        return;
      }
      chosen[i]++;
      for (int j = i + 1; j < size; j++) {
        chosen[j] = chosen[j - 1] + 1;
      }
    }
  }

  private static boolean isPossible(long mask, List<Exclusion> exclusions) {
    for (Exclusion exclusion : exclusions) {
      if (exclusion.excludes(mask)) {
        return false;
      }
    }
    return true;
  }

  boolean isEmpty() {
    return masks.length == 0;
  }

  int size() {
    return masks.length;
  }

  long mask(int candidate) {
    return masks[candidate];
  }

  /** The probability of a candidate. */
  double probability(int candidate) {
    return weights[candidate] / total;
  }

  /** The most probable candidate; the smaller of two. */
  int best() {
    int best = 0;
    for (int i = 1; i < masks.length; i++) {
      if (weights[i] > weights[best]) {
        best = i;
      }
    }
    return best;
  }

  /** The probability that a row fails which has the values of these parameters. */
  double probabilityWithin(long mask) {
    double sum = 0;
    for (int i = 0; i < masks.length; i++) {
      if ((masks[i] & ~mask) == 0) {
        sum += weights[i];
      }
    }
    return sum / total;
  }

  int[] row() {
    return row;
  }
}
