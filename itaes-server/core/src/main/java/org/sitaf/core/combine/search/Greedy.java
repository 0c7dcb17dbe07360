package org.sitaf.core.combine.search;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;
import org.sitaf.core.combine.feasible.Propagation;

/**
 * Grows an array row by row, as AETG does: starts with an uncovered tuple, then chooses the value
 * that covers most for each column, and finally improves the row by hill climbing.
 */
public final class Greedy {
  private static final int MAX_CLIMBS = 6;

  private final Symbols symbols;
  private final Coverage coverage;
  private final Feasibility feasibility;
  private final SeededRandom random;
  private final Budget budget;
  private final int[] order;
  private final int[][] gains;

  /**
   * Creates a generator. It spends from the budget but does not stop when it is used up, because
   * the array must be complete.
   */
  public Greedy(
      Symbols symbols,
      Coverage coverage,
      Feasibility feasibility,
      SeededRandom random,
      Budget budget) {
    this.symbols = symbols;
    this.coverage = coverage;
    this.feasibility = feasibility;
    this.random = random;
    this.budget = budget;
    this.order = new int[symbols.columns()];
    this.gains = new int[symbols.columns()][];
    for (int c = 0; c < order.length; c++) {
      order[c] = c;
      gains[c] = new int[symbols.levels(c)];
    }
  }

  /**
   * Adds rows until all tuples are covered.
   *
   * @param tries number of candidates for each row
   * @param limit maximum number of rows
   * @return whether all tuples are covered
   */
  public boolean grow(List<Row> rows, int tries, int limit) {
    while (coverage.uncovered() > 0) {
      if (rows.size() >= limit) {
        return false;
      }
      Row row = best(tries);
      coverage.add(row);
      rows.add(row);
    }
    return true;
  }

  private Row best(int tries) {
    Row best = null;
    int most = -1;
    for (int i = 0; i < tries; i++) {
      Row row = new Row(symbols);
      Coverage.Tuple tuple = coverage.pick(random);
      for (int j = 0; j < tuple.columns().length; j++) {
        row.set(tuple.columns()[j], tuple.values()[j]);
      }
      row = fill(row);
      if (row == null) {
        throw new IllegalStateException("no allowed row for a possible tuple");
      }
      int covered = countNewlyCovered(row);
      if (covered > most) {
        most = covered;
        best = row;
      }
    }
    return java.util.Objects.requireNonNull(best);
  }

  /** The number of tuples that a row would newly cover, counted once per column. */
  private int countNewlyCovered(Row row) {
    int sum = 0;
    for (int c = 0; c < order.length; c++) {
      sum += coverage.gain(row, c, row.value(c));
    }
    budget.spend((long) order.length * coverage.cost());
    return sum;
  }

  /**
   * Fills the free cells of a row.
   *
   * @return null if no allowed row contains the chosen cells
   */
  public @Nullable Row fill(Row partial) {
    if (feasibility.contradiction()) {
      return null;
    }
    boolean[] fixed = new boolean[order.length];
    for (int c = 0; c < fixed.length; c++) {
      fixed[c] = partial.value(c) != Row.FREE;
    }
    Row row = fillByPropagation(partial);
    if (row == null) {
      row = fillBySolver(partial);
    }
    if (row != null) {
      climb(row, fixed);
      feasibility.witness(row);
    }
    return row;
  }

  /**
   * Inserts a tuple into a row with few other changes.
   *
   * @return an allowed row; null if propagation finds none or the fixed cells forbid the tuple
   */
  @Nullable Row repair(Row row, int[] columns, int[] values) {
    Propagation propagation = feasibility.propagation();
    int mark = propagation.mark();
    Row target = new Row(symbols, row.values());
    boolean open = true;
    for (int i = 0; open && i < columns.length; i++) {
      open = propagation.choose(columns[i], values[i]);
      target.set(columns[i], values[i]);
    }
    for (int c = 0; open && c < order.length; c++) {
      open = !row.fixed(c) || propagation.choose(c, row.value(c));
    }
    random.shuffle(order);
    for (int i = 0; open && i < order.length; i++) {
      int c = order[i];
      if (!feasibility.rules().isConstrained(c)) {
        continue;
      }
      int before = propagation.mark();
      if (!propagation.open(c, target.value(c)) || !propagation.choose(c, target.value(c))) {
        propagation.undo(before);
        open = chooseOpen(target, c, propagation);
      }
    }
    propagation.undo(mark);
    return open && (feasibility.propagatesAll() || feasibility.rules().allow(target))
        ? target
        : null;
  }

  private @Nullable Row fillByPropagation(Row partial) {
    Row row = new Row(symbols, partial.values());
    if (feasibility.rules().isEmpty()) {
      fillFreely(row);
      return row;
    }
    Propagation propagation = feasibility.propagation();
    int mark = propagation.mark();
    boolean open = true;
    for (int c = 0; open && c < order.length; c++) {
      open = row.value(c) == Row.FREE || propagation.choose(c, row.value(c));
    }
    random.shuffle(order);
    for (int i = 0; open && i < order.length; i++) {
      open = row.value(order[i]) != Row.FREE || chooseOpen(row, order[i], propagation);
    }
    propagation.undo(mark);
    return open && feasibility.rules().allow(row) ? row : null;
  }

  private boolean chooseOpen(Row row, int column, Propagation propagation) {
    int[] out = gains[column];
    coverage.gains(row, column, out);
    budget.spend(coverage.gainsCost(out.length));
    while (true) {
      int value = -1;
      int start = random.nextInt(out.length);
      for (int i = 0; i < out.length; i++) {
        int v = start + i < out.length ? start + i : start + i - out.length;
        if (propagation.open(column, v) && (value < 0 || out[v] > out[value])) {
          value = v;
        }
      }
      if (value < 0) {
        return false;
      }
      int mark = propagation.mark();
      if (propagation.choose(column, value)) {
        row.set(column, value);
        return true;
      }
      propagation.undo(mark);
      if (!propagation.excludeValue(column, value)) {
        return false;
      }
    }
  }

  private void fillFreely(Row row) {
    random.shuffle(order);
    for (int c : order) {
      if (row.value(c) == Row.FREE) {
        row.set(c, best(row, c, false));
      }
    }
  }

  private @Nullable Row fillBySolver(Row partial) {
    Row row = feasibility.complete(partial);
    if (row != null) {
      fillFreely(row);
    }
    return row;
  }

  /** The allowed value that covers most tuples; ties are broken at random. */
  private int best(Row row, int column, boolean constrained) {
    int[] out = gains[column];
    coverage.gains(row, column, out);
    budget.spend(coverage.gainsCost(out.length));
    int value = row.value(column);
    int most = value < 0 ? -1 : out[value];
    int start = random.nextInt(out.length);
    for (int i = 0; i < out.length; i++) {
      int v = start + i < out.length ? start + i : start + i - out.length;
      if (out[v] > most && (!constrained || feasibility.rules().allow(row, column, v))) {
        most = out[v];
        value = v;
      }
    }
    return value;
  }

  private void climb(Row row, boolean[] fixed) {
    boolean changed = true;
    for (int i = 0; changed && i < MAX_CLIMBS; i++) {
      changed = false;
      random.shuffle(order);
      for (int c : order) {
        if (!fixed[c]) {
          int value = best(row, c, feasibility.rules().isConstrained(c));
          changed |= value != row.value(c);
          row.set(c, value);
        }
      }
    }
  }
}
