package org.sitaf.core.combine.search;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Dice;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;

/**
 * Tabu search that removes rows: takes the row that is missed least away, then forces uncovered
 * tuples, one at a time, into the row where that costs least, until all are covered again.
 *
 * <p>After J. Lin, C. Luo, S. Cai, K. Su, D. Hao, L. Zhang: TCA, an efficient two-mode
 * meta-heuristic algorithm for combinatorial test generation (ASE 2015).
 */
public final class TupleForcing {
  private static final int TENURE = 3;
  private static final int STEP_COST = 150;
  private static final int MAX_LOOSE_ROWS = 24;

  /** Of many rows, so many compete for being taken away. */
  private static final int MAX_COMPARED = 64;

  private final Symbols symbols;
  private final Coverage coverage;
  private final Feasibility feasibility;
  private final Greedy greedy;
  private final Dice dice;
  private Budget budget = new Budget(0);
  private final List<Row> rows;
  private final boolean constrained;
  private final int looseEvery;
  private long step;

  /**
   * A search over complete rows that the coverage counts.
   *
   * @param rows changed in place
   */
  public TupleForcing(
      Symbols symbols,
      Coverage coverage,
      Feasibility feasibility,
      Greedy greedy,
      Dice dice,
      List<Row> rows) {
    this.symbols = symbols;
    this.coverage = coverage;
    this.feasibility = feasibility;
    this.greedy = greedy;
    this.dice = dice;
    this.rows = rows;
    this.constrained = !feasibility.rules().isEmpty();
    this.looseEvery = constrained ? 50 : 1000;
    this.step = TENURE + 1;
  }

  /** Hears of each smaller array. */
  public interface Listener {
    /** So many rows cover everything now, or no fewer yet. */
    void heard(int rows);
  }

  /**
   * Removes rows until there are no more than {@code enough}, or the budget is spent. The present
   * rows may still miss tuples when they are fewer than those of the complete array; called again,
   * it goes on where it was.
   *
   * @param complete the smallest complete array so far
   * @return the smallest complete array found
   */
  public List<int[]> shrink(List<int[]> complete, int enough, Budget spent, Listener listener) {
    budget = spent;
    List<int[]> best = coverage.uncovered() == 0 ? snapshot() : complete;
    while (best.size() > enough && !budget.spent() && (coverage.uncovered() > 0 || removeOne())) {
      long next = step + 256;
      while (coverage.uncovered() > 0 && !budget.spent()) {
        force(coverage.pick(dice));
        if (step >= next) {
          next = step + 256;
          listener.heard(best.size());
        }
      }
      if (coverage.uncovered() == 0) {
        best = snapshot();
        budget.renew();
        listener.heard(best.size());
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
    int start = dice.below(count);
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

  /** What only this row covers, counted once for each column of each tuple. */
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
    if (dice.below(looseEvery) == 0) {
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

  /** The place of the one cell in which a row differs from a tuple; -1: there are several. */
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

  /** Puts a tuple into the best of some rows, changing as many cells as that takes. */
  private void forceAnywhere(int[] columns, int[] values) {
    Row best = null;
    Row bestTarget = null;
    int most = Integer.MIN_VALUE;
    int start = dice.below(rows.size());
    int tried = 0;
    for (int i = 0; i < rows.size() && tried < MAX_LOOSE_ROWS; i++) {
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

  /** The row with the tuple in it, and with as few other changes as the constraints leave. */
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
