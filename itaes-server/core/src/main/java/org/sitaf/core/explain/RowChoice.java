package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.jspecify.annotations.Nullable;

/**
 * Chooses rows to execute: some values of a failing row, the others from a row that passed, so that
 * they rarely cause another failure.
 */
final class RowChoice {
  private static final int MAX_BASES = 60;
  private static final int ORDERS = 5;

  /** Estimated probability that two values cause a failure that no row passed with. */
  private static final double RISK = 0.02;

  private static final int MAX_ATTEMPTS = 400;

  private final History history;
  private final List<Tuple> causes;
  private final Random random;
  private final int[] levels;

  RowChoice(History history, List<Tuple> causes, Random random) {
    this.history = history;
    this.causes = causes;
    this.random = random;
    this.levels = history.combinations().levels();
  }

  /** The row whose outcome says most about the candidates; null if none can be executed. */
  int @Nullable [] split(Candidates candidates, long free) {
    int[] failed = candidates.row();
    int[] best = null;
    double bestScore = Double.POSITIVE_INFINITY;
    for (int[] base : bases(failed)) {
      for (int order = 0; order < ORDERS; order++) {
        int[] row = base.clone();
        long kept = History.agreement(row, failed) & free;
        double within = candidates.probabilityWithin(kept);
        for (int i : shuffled(free & ~kept)) {
          if (within >= 0.45) {
            break;
          }
          double next = candidates.probabilityWithin(kept | 1L << i);
          if (next <= 0.62 || next - 0.5 < 0.5 - within) {
            row[i] = failed[i];
            kept |= 1L << i;
            within = next;
          }
        }
        // The risk is asked last, because it looks at all rows that passed.
        if (within <= 0.01 || within >= 0.99 || !isUsable(row, failed)) {
          continue;
        }
        double risk = risk(row, failed);
        double fails = within + (1 - within) * risk;
        double score = Math.abs(fails - 0.5) + risk;
        if (score < bestScore) {
          best = row;
          bestScore = score;
        }
      }
    }
    return best;
  }

  /** A row that has only these values of the failing row, if possible, and no known cause. */
  int @Nullable [] only(int[] failed, long mask, long free, boolean avoidCauses) {
    int[] best = null;
    double bestScore = Double.POSITIVE_INFINITY;
    for (int attempt = 0; attempt < MAX_ATTEMPTS; attempt++) {
      List<int[]> bases = bases(failed);
      int[] row =
          bases.isEmpty() || attempt >= MAX_ATTEMPTS / 2
              ? randomRow()
              : bases.get(random.nextInt(bases.size())).clone();
      for (int i = 0; i < row.length; i++) {
        if ((mask >>> i & 1) == 1 || (free >>> i & 1) == 0) {
          row[i] = failed[i];
        } else if (row[i] == failed[i] && levels[i] > 1 && attempt % 2 == 0) {
          row[i] = (failed[i] + 1 + random.nextInt(levels[i] - 1)) % levels[i];
        }
      }
      long more = History.agreement(row, failed) & free & ~mask;
      int further = 10 * Long.bitCount(more);
      if (further >= bestScore || !(avoidCauses ? isUsable(row, failed) : isNew(row, failed))) {
        continue;
      }
      double score = further + risk(row, failed);
      if (score < bestScore) {
        best = row;
        bestScore = score;
        if (more == 0 && attempt > 40) {
          break;
        }
      }
    }
    return best;
  }

  private boolean isNew(int[] row, int[] failed) {
    return !history.addsInvalid(row, failed)
        && !history.wasExecuted(row)
        && history.combinations().allowed().test(row);
  }

  /**
   * Whether a row may be executed, was not executed, and contains neither a known cause nor an
   * invalid value that the failing row does not have.
   */
  boolean isUsable(int[] row, int[] failed) {
    return causes.stream().noneMatch(c -> c.isIn(row))
        && !history.isExplained(row)
        && isNew(row, failed);
  }

  private int[] randomRow() {
    int[] row = new int[levels.length];
    for (int i = 0; i < row.length; i++) {
      row[i] = random.nextInt(levels[i]);
    }
    return row;
  }

  /** Rows to take safe values from: those that passed, or any if none did. */
  private List<int[]> bases(int[] failed) {
    List<int[]> bases = new ArrayList<>();
    List<int[]> passing = history.passingValid();
    int offset = passing.isEmpty() ? 0 : random.nextInt(passing.size());
    for (int i = 0; i < Math.min(MAX_BASES, passing.size()); i++) {
      bases.add(passing.get((offset + i) % passing.size()));
    }
    for (int i = bases.size(); i < Math.min(MAX_BASES, 20); i++) {
      int[] row = randomRow();
      for (int p = 0; p < row.length; p++) {
        if (row[p] == failed[p] && levels[p] > 1) {
          row[p] = (failed[p] + 1 + random.nextInt(levels[p] - 1)) % levels[p];
        }
      }
      bases.add(row);
    }
    return bases;
  }

  /** The probability that values fail together of which not all are from the failing row. */
  private double risk(int[] row, int[] failed) {
    int n = row.length;
    long[] together = new long[n];
    for (int[] p : history.passing()) {
      long agreement = History.agreement(p, row);
      for (int i = 0; i < n; i++) {
        if ((agreement >>> i & 1) == 1) {
          together[i] |= agreement;
        }
      }
    }
    long kept = History.agreement(row, failed);
    int unknown = 0;
    for (int i = 0; i < n; i++) {
      long suspicious = ~together[i] & ((1L << n) - 1) & -1L << i;
      if ((kept >>> i & 1) == 1) {
        suspicious &= ~kept;
      }
      unknown += Long.bitCount(suspicious);
    }
    return 1 - Math.pow(1 - RISK, unknown);
  }

  private int[] shuffled(long mask) {
    int[] positions = new int[Long.bitCount(mask)];
    long left = mask;
    for (int i = 0; i < positions.length; i++) {
      positions[i] = Long.numberOfTrailingZeros(left);
      left &= left - 1;
    }
    for (int i = positions.length - 1; i > 0; i--) {
      int j = random.nextInt(i + 1);
      int swapped = positions[i];
      positions[i] = positions[j];
      positions[j] = swapped;
    }
    return positions;
  }
}
