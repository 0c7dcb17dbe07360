import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.sequence.CoveringWords;
import org.sitaf.core.sequence.Machine;
import org.sitaf.core.sequence.array.TupleSpace;

/** Sizes and times of sequence covering arrays, compared with their targets. */
public final class SequenceSizes {
  private static final double MOST_SECONDS = 5;

  private int held;
  private int missed;
  private final StringBuilder misses = new StringBuilder();

  /** Takes {@code --short} for a part of the sizes. */
  public static void main(String[] arguments) {
    boolean isShort = List.of(arguments).contains("--short");
    System.exit(new SequenceSizes().measure(isShort) ? 0 : 1);
  }

  private boolean measure(boolean isShort) {
    System.out.println("  t   n  length  repeat  cases  target  seconds");
    int[][] distinct = {
      {3, 5, 7}, {3, 6, 8}, {3, 8, 9}, {3, 10, 10}, {3, 20, 16}, {3, 40, 24}, {4, 6, 27}, {4, 8, 0}
    };
    for (int[] row : distinct) {
      if (!isShort || row[1] < 20) {
        measure(row[0], row[1], row[1], false, row[2]);
      }
    }
    for (int t = 2; t <= 3; t++) {
      for (int n = 4; n <= 8; n += isShort ? 4 : 1) {
        for (int length = 2 * t; length <= 4 * t; length += isShort ? t : 1) {
          double tuples = (t == 2 ? 1.3 : 1.6) * Math.pow(n, t);
          measure(t, n, length, true, (int) Math.ceil(tuples / choose(length, t)) + 1);
        }
      }
    }
    System.out.println(
        missed == 0
            ? "sequences: held"
            : "sequences: short: " + missed + " of " + (held + missed) + " sizes:" + misses);
    return missed == 0;
  }

  private void measure(int t, int n, int length, boolean repeat, int target) {
    TupleSpace space = new TupleSpace(n, t);
    long start = System.nanoTime();
    CoveringWords words = new CoveringWords(Machine.free(n), space, length, repeat);
    BitSet required = words.allowed();
    List<int[]> found = words.cover(required, Effort.DEFAULT, 1, Progress.NONE);
    double seconds = (System.nanoTime() - start) / 1e9;
    boolean complete = covers(found, t, n, required);
    boolean good =
        complete
            && (target == 0 || found.size() <= target)
            && (repeat || seconds <= MOST_SECONDS);
    if (good) {
      held++;
    } else {
      missed++;
      misses.append(
          String.format(Locale.ROOT, " (t=%d n=%d length=%d: %d)", t, n, length, found.size()));
    }
    System.out.printf(
        Locale.ROOT,
        "%3d %3d %7d %7s %6d %7s %8.2f %s%n",
        t,
        n,
        length,
        repeat,
        found.size(),
        target == 0 ? "-" : Integer.toString(target),
        seconds,
        !complete ? "INCOMPLETE" : good ? "" : "short");
  }

  /** Independent of the generator: marks every choice of places of every word. */
  private static boolean covers(List<int[]> words, int t, int n, BitSet required) {
    BitSet covered = new BitSet();
    for (int[] word : words) {
      mark(word, 0, 0, t, n, covered);
    }
    return covered.equals(required);
  }

  private static void mark(int[] word, int from, int tuple, int left, int n, BitSet covered) {
    if (left == 0) {
      covered.set(tuple);
      return;
    }
    for (int p = from; p < word.length; p++) {
      mark(word, p + 1, tuple * n + word[p], left - 1, n, covered);
    }
  }

  private static double choose(int n, int k) {
    double ways = 1;
    for (int i = 0; i < k; i++) {
      ways = ways * (n - i) / (i + 1);
    }
    return ways;
  }
}
