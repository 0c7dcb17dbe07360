package org.sitaf.core.trajectory;

import java.util.BitSet;
import java.util.Collection;

/**
 * Selects samples of a trace for display. If there are too many, the trace is divided into equal
 * parts, and the samples with the minimum and the maximum of each signal remain of each part, so
 * that short peaks remain visible.
 */
public final class TraceReduction {
  private TraceReduction() {}

  /**
   * The indices of the remaining samples, ascending. The first and the last sample remain.
   *
   * @param most number of samples, at least {@code 4 + 4 * trace.names().size()}; the samples of
   *     {@code nanos} are additional
   * @param nanos times whose samples remain, relative to the call
   */
  public static int[] samples(Trace trace, int most, Collection<Long> nanos) {
    int count = trace.count();
    int perPart = 2 * trace.names().size();
    if (most < 4 + 2 * perPart) {
      throw new IllegalArgumentException(most + " samples are too few for the signals");
    }
    BitSet kept = new BitSet(count);
    if (count <= most) {
      kept.set(0, count);
    } else {
      kept.set(0);
      kept.set(count - 1);
      int parts = (most - 2) / perPart;
      for (double[] column : trace.columns()) {
        keepExtremes(column, parts, kept);
      }
    }
    for (long at : nanos) {
      long sample = (at - trace.firstNanos()) / trace.stepNanos();
      kept.set((int) Math.max(0, Math.min(count - 1, sample)));
    }
    return kept.stream().toArray();
  }

  private static void keepExtremes(double[] column, int parts, BitSet kept) {
    for (int part = 0; part < parts; part++) {
      int from = (int) ((long) column.length * part / parts);
      int to = (int) ((long) column.length * (part + 1) / parts);
      int least = from;
      int greatest = from;
      for (int k = from + 1; k < to; k++) {
        // A NaN is the greatest number.
        least = Double.compare(column[k], column[least]) < 0 ? k : least;
        greatest = Double.compare(column[k], column[greatest]) > 0 ? k : greatest;
      }
      if (from < to) {
        kept.set(least);
        kept.set(greatest);
      }
    }
  }
}
