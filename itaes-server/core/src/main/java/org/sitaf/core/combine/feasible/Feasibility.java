package org.sitaf.core.combine.feasible;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.TooManyCombinationsException;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;

/**
 * Says whether values can stand together in an allowed row: by a known row that holds them, by
 * propagation, and where neither decides, by the solver.
 */
public final class Feasibility {
  /** Values of a column that takes part in a constraint. */
  private static final int MAX_CONSTRAINED = 10_000;

  private final Symbols symbols;
  private final Rules rules;
  private final Propagation propagation;
  private final boolean contradiction;
  private final List<int[]> forbidden;
  private @Nullable Solver solver;

  /** For each symbol, the set of known allowed rows that hold it. */
  private final long[][] witnesses;

  private int known;

  /**
   * The judge of these constraints.
   *
   * @throws TooManyCombinationsException when a constrained column has more values than can be
   *     judged one by one
   */
  public Feasibility(Symbols symbols, List<Constraint> constraints) {
    this.symbols = symbols;
    for (Constraint constraint : constraints) {
      for (int column : constraint.parameters()) {
        if (symbols.levels(column) > MAX_CONSTRAINED) {
          throw new TooManyCombinationsException(
              "values of a parameter that a condition speaks of",
              BigInteger.valueOf(symbols.levels(column)),
              MAX_CONSTRAINED);
        }
      }
    }
    this.rules = new Rules(symbols, constraints);
    this.forbidden = rules.forbidden();
    this.propagation = new Propagation(symbols, forbidden);
    this.witnesses = new long[symbols.count()][rules.isEmpty() ? 0 : 4];
    // Propagation alone overlooks contradictions that take a search to find.
    this.contradiction = !propagation.start() || solve(new Row(symbols)) == null;
  }

  /** The constraints. */
  public Rules rules() {
    return rules;
  }

  /** Unit propagation from what the constraints alone imply; callers undo what they choose. */
  public Propagation propagation() {
    return propagation;
  }

  /** Whether the constraints contradict each other: no row is allowed. */
  public boolean contradiction() {
    return contradiction;
  }

  /** Whether propagation knows all constraints. */
  public boolean propagatesAll() {
    return rules.complete();
  }

  /**
   * An allowed row that agrees with the chosen cells; unconstrained columns stay as they are.
   *
   * @return null where there is none
   */
  public @Nullable Row complete(Row partial) {
    return contradiction ? null : solve(partial);
  }

  private @Nullable Row solve(Row partial) {
    if (rules.isEmpty()) {
      return new Row(symbols, partial.values());
    }
    if (solver == null) {
      solver = new Solver(symbols, rules, forbidden);
    }
    Row row = solver.complete(partial);
    if (row != null) {
      witness(row);
    }
    return row;
  }

  /** Remembers an allowed row, whose unconstrained columns may be free. */
  public void witness(Row row) {
    if (rules.isEmpty()) {
      return;
    }
    int word = known >>> 6;
    for (int c = 0; c < symbols.columns(); c++) {
      if (!rules.touches(c)) {
        continue;
      }
      int s = symbols.symbol(c, row.value(c));
      if (word >= witnesses[s].length) {
        witnesses[s] = Arrays.copyOf(witnesses[s], 2 * word);
      }
      witnesses[s][word] |= 1L << known;
    }
    known++;
  }

  /** Whether an allowed row can hold these values. */
  public boolean possible(int[] columns, int[] values) {
    if (contradiction) {
      return false;
    }
    if (witnessed(columns, values)) {
      return true;
    }
    int mark = propagation.mark();
    boolean open = true;
    for (int i = 0; open && i < columns.length; i++) {
      open = propagation.choose(columns[i], values[i]);
    }
    propagation.undo(mark);
    if (!open) {
      return false;
    }
    Row partial = new Row(symbols);
    for (int i = 0; i < columns.length; i++) {
      partial.set(columns[i], values[i]);
    }
    return complete(partial) != null;
  }

  private boolean witnessed(int[] columns, int[] values) {
    List<long[]> sets = new ArrayList<>(columns.length);
    int words = Integer.MAX_VALUE;
    for (int i = 0; i < columns.length; i++) {
      if (rules.touches(columns[i])) {
        long[] set = witnesses[symbols.symbol(columns[i], values[i])];
        sets.add(set);
        words = Math.min(words, set.length);
      }
    }
    if (sets.isEmpty()) {
      return true;
    }
    for (int w = 0; w < words; w++) {
      long common = -1L;
      for (long[] set : sets) {
        common &= set[w];
      }
      if (common != 0) {
        return true;
      }
    }
    return false;
  }
}
