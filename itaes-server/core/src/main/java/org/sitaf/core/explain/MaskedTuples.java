package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * The tuples of the suite's strength that occur only in rows that fail by a known cause. Another
 * cause may be hidden among them, so they are executed without the known one.
 */
final class MaskedTuples {
  private static final int ATTEMPTS = 60;
  private static final int MAX_TUPLES = 4_000;

  private final History history;
  private final List<Tuple> causes;
  private final RowChoice rows;
  private final long free;
  private final Random random = new Random(7);

  MaskedTuples(History history, List<Tuple> causes, RowChoice rows, long free) {
    this.history = history;
    this.causes = causes;
    this.rows = rows;
    this.free = free;
  }

  /** Executes the row with the most such tuples; false if there is none. */
  boolean execute() throws InterruptedException {
    Set<Tuple> masked = masked();
    if (masked.isEmpty()) {
      return false;
    }
    int[] best = null;
    long most = 0;
    List<Combinations.Row> failing = history.failing();
    for (Combinations.Row failed : failing) {
      for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
        int[] row = withoutCauses(failed.values());
        if (row == null) {
          continue;
        }
        long count = masked.stream().filter(t -> t.isIn(row)).count();
        if (count > most && rows.isUsable(row, failed.values())) {
          best = row;
          most = count;
        }
      }
    }
    if (best == null) {
      return false;
    }
    history.execute(best);
    return true;
  }

  /** Tuples without a known cause that are in a failing row of the suite and in no passing row. */
  private Set<Tuple> masked() {
    int strength = Math.max(1, Math.min(3, history.combinations().strength()));
    Set<Tuple> masked = new HashSet<>();
    for (Combinations.Row failed : history.combinations().executed()) {
      if (failed.outcome().failed() && masked.size() < MAX_TUPLES) {
        add(failed.values(), strength, 0, 0L, masked);
      }
    }
    return masked;
  }

  private void add(int[] row, int left, int from, long mask, Set<Tuple> masked) {
    if (left == 0) {
      Tuple tuple = Tuple.of(row, mask);
      if (causes.stream().noneMatch(c -> c.isPartOf(tuple)) && !history.isRefuted(tuple)) {
        masked.add(tuple);
      }
      return;
    }
    for (int i = from; i < row.length; i++) {
      if ((free >>> i & 1) == 1) {
        add(row, left - 1, i + 1, mask | 1L << i, masked);
      }
    }
  }

  private int @org.jspecify.annotations.Nullable [] withoutCauses(int[] failed) {
    int[] row = failed.clone();
    int[] levels = history.combinations().levels();
    for (int step = 0; step < 8; step++) {
      List<Tuple> in = causes.stream().filter(c -> c.isIn(row)).toList();
      if (in.isEmpty()) {
        return row;
      }
      List<Integer> choices = new ArrayList<>();
      for (int i = 0; i < row.length; i++) {
        if ((in.get(0).mask() >>> i & 1) == 1) {
          choices.add(i);
        }
      }
      if (choices.isEmpty()) {
        return null;
      }
      int changed = choices.get(random.nextInt(choices.size()));
      row[changed] = (row[changed] + 1 + random.nextInt(levels[changed] - 1)) % levels[changed];
    }
    return null;
  }
}
