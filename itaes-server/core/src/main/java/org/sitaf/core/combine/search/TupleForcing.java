package org.sitaf.core.combine.search;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;

/**
 * Tabu search that removes rows: removes the row with the smallest loss, then forces uncovered
 * tuples one by one into the row with the least cost, until all tuples are covered again.
 *
 * <p>After J. Lin, C. Luo, S. Cai, K. Su, D. Hao, L. Zhang: TCA, an efficient two-mode
 * meta-heuristic algorithm for combinatorial test generation (ASE 2015).
 */
public final class TupleForcing {
  private static final int TENURE = 3;
  private static final int STEP_COST = 150;
  private static final int MAX_RANDOM_ROWS = 24;

  /** Maximum number of rows that are compared for removal. */
  private static final int MAX_COMPARED = 64;

  private final Symbols symbols;
  private final Coverage coverage;
  private final Feasibility feasibility;
  private final Greedy greedy;
  private final SeededRandom random;
  private Budget budget = new Budget(0);
  private final List<Row> rows;
  private final boolean constrained;
  private final int randomMoveInterval;
  private long step;

  /**
   * Creates a search over rows that were added to the coverage.
   *
   * @param rows complete rows; modified in place
   */
  public TupleForcing(
      Symbols symbols,
      Coverage coverage,
      Feasibility feasibility,
      Greedy greedy,
      SeededRandom random,
      List<Row> rows) {
    this.symbols = symbols;
    this.coverage = coverage;
    this.feasibility = feasibility;
    this.greedy = greedy;
    this.random = random;
    this.rows = rows;
    this.constrained = !feasibility.rules().isEmpty();
    this.randomMoveInterval = constrained ? 50 : 1000;
    this.step = TENURE + 1;
  }

  /** Receives the progress. */
  public interface Listener {
    /** Called with the number of rows of the smallest complete array so far. */
    void onProgress(int rows);
  }

  /**
   * Removes rows until at most {@code targetSize} remain or the budget is used up. The current rows
   * may be incomplete if they are fewer than those of {@code complete}. A further call continues
   * the search.
   *
   * @param complete the smallest complete array so far
   * @return the smallest complete array found
   */
  public List<int[]> shrink(List<int[]> complete, int targetSize, Budget spent, Listener listener) {
    budget = spent;
    List<int[]> best = coverage.uncovered() == 0 ? snapshot() : complete;
    while (best.size() > targetSize
        && !budget.isExhausted()
        && (coverage.uncovered() > 0 || removeOne())) {
      long next = step + 256;
      while (coverage.uncovered() > 0 && !budget.isExhausted()) {
        force(coverage.pick(random));
        if (step >= next) {
          next = step + 256;
          listener.onProgress(best.size());
        }
      }
      if (coverage.uncovered() == 0) {
        best = snapshot();
        budget.recordProgress();
        listener.onProgress(best.size());
      }
    }
    return best;
  }

  private List<int[]> snapshot() {
    List<int[]> copy = new ArrayList<>(rows.size());
    for (Row row : rows) {
      copy.add(row.values());
    }
    return copy;
  }

  private boolean removeOne() {
    int least = Integer.MAX_VALUE;
    int at = -1;
    int count = rows.size();
    int start = random.nextInt(count);
    int step = count / MAX_COMPARED + 1;
    for (int i = 0; i < count; i += step) {
      int r = (start + i) % count;
      if (!rows.get(r).kept()) {
        int missed = missed(rows.get(r));
        if (missed < least) {
          least = missed;
          at = r;
        }
      }
    }
    for (int r = 0; at < 0 && r < count; r++) {
      at = rows.get(r).kept() ? -1 : r;
    }
    if (at < 0) {
      return false;
    }
    coverage.remove(rows.get(at));
    rows.set(at, rows.get(count - 1));
    rows.remove(count - 1);
    return true;
  }

  /** The number of tuples that only this row covers, counted once per column. */
  private int missed(Row row) {
    int sum = 0;
    for (int c = 0; c < symbols.columns(); c++) {
      sum += coverage.loss(row, c);
    }
    budget.spend((long) symbols.columns() * coverage.cost());
    return sum;
  }

  private void force(Coverage.Tuple tuple) {
    step++;
    int[] columns = tuple.columns();
    int[] values = tuple.values();
    if (random.nextInt(randomMoveInterval) == 0) {
      forceAnywhere(columns, values);
      return;
    }
    Row best = null;
    int bestAt = -1;
    int most = Integer.MIN_VALUE;
    long oldest = Long.MAX_VALUE;
    int evaluated = 0;
    for (int r = 0; r < rows.size(); r++) {
      Row row = rows.get(r);
      int at = onlyDifference(row, columns, values);
      if (at < 0 || row.fixed(columns[at]) || step - row.touched(columns[at]) <= TENURE) {
        continue;
      }
      int c = columns[at];
      if (constrained && !feasibility.rules().allow(row, c, values[at])) {
        continue;
      }
      evaluated++;
      int delta = coverage.gain(row, c, values[at]) - coverage.loss(row, c);
      if (delta > most || (delta == most && row.touched(c) < oldest)) {
        most = delta;
        oldest = row.touched(c);
        best = row;
        bestAt = at;
      }
    }
    budget.spend(2L * evaluated * coverage.cost() + STEP_COST + 3L * rows.size());
    if (best == null) {
      forceAnywhere(columns, values);
    } else {
      change(best, columns[bestAt], values[bestAt]);
    }
  }

  /** The index of the only cell in which a row differs from a tuple; -1 if there are several. */
  private static int onlyDifference(Row row, int[] columns, int[] values) {
    int at = -1;
    for (int i = 0; i < columns.length; i++) {
      if (row.value(columns[i]) != values[i]) {
        if (at >= 0) {
          return -1;
        }
        at = i;
      }
    }
    return at;
  }

  private void change(Row row, int column, int value) {
    coverage.change(row, column, value);
    row.touch(column, step);
    budget.spend(coverage.changeCost());
  }

  /** Forces a tuple into the best of some rows, changing as many cells as necessary. */
  private void forceAnywhere(int[] columns, int[] values) {
    Row best = null;
    Row bestTarget = null;
    int most = Integer.MIN_VALUE;
    int start = random.nextInt(rows.size());
    int tried = 0;
    for (int i = 0; i < rows.size() && tried < MAX_RANDOM_ROWS; i++) {
      Row row = rows.get((start + i) % rows.size());
      Row target = target(row, columns, values);
      if (target == null) {
        continue;
      }
      tried++;
      budget.spend((constrained ? 60L : 3L) * symbols.columns());
      int delta = 0;
      for (int c = 0; c < symbols.columns(); c++) {
        if (target.value(c) != row.value(c)) {
          delta += coverage.gain(target, c, target.value(c)) - coverage.loss(row, c);
          budget.spend(2L * coverage.cost());
        }
      }
      if (delta > most) {
        most = delta;
        best = row;
        bestTarget = target;
      }
    }
    if (best != null && bestTarget != null) {
      for (int c = 0; c < symbols.columns(); c++) {
        if (bestTarget.value(c) != best.value(c)) {
          change(best, c, bestTarget.value(c));
        }
      }
    }
  }

  /** A copy of the row with the tuple, with as few other changes as the constraints allow. */
  private @Nullable Row target(Row row, int[] columns, int[] values) {
    Row target = new Row(symbols, row.values());
    for (int i = 0; i < columns.length; i++) {
      if (row.value(columns[i]) != values[i]) {
        if (row.fixed(columns[i])) {
          return null;
        }
        target.set(columns[i], values[i]);
      }
    }
    if (!constrained || feasibility.rules().allow(target)) {
      return target;
    }
    return greedy.repair(row, columns, values);
  }
}
