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
 * Decides whether an allowed row can contain given values: first by known rows, then by
 * propagation, and finally by the solver.
 */
public final class Feasibility {
  /** Maximum number of values of a constrained column. */
  private static final int MAX_CONSTRAINED = 10_000;

  private final Symbols symbols;
  private final Rules rules;
  private final Propagation propagation;
  private final boolean contradiction;
  private final List<int[]> forbidden;
  private @Nullable Solver solver;

  /** For each symbol, the set of known allowed rows that contain it. */
  private final long[][] witnesses;

  private int known;

  /**
   * Prepares the constraints.
   *
   * @throws TooManyCombinationsException if a constrained column has too many values
   */
  public Feasibility(Symbols symbols, List<Constraint> constraints) {
    this.symbols = symbols;
    for (Constraint constraint : constraints) {
      for (int column : constraint.parameters()) {
        if (symbols.levels(column) > MAX_CONSTRAINED) {
          throw new TooManyCombinationsException(
              "number of values of a parameter in a condition",
              BigInteger.valueOf(symbols.levels(column)),
              MAX_CONSTRAINED);
        }
      }
    }
    this.rules = new Rules(symbols, constraints);
    this.forbidden = rules.forbidden();
    this.propagation = new Propagation(symbols, forbidden);
    this.witnesses = new long[symbols.count()][rules.isEmpty() ? 0 : 4];
    // Propagation alone does not find all contradictions.
    this.contradiction = !propagation.start() || solve(new Row(symbols)) == null;
  }

  /** The constraints as rules. */
  public Rules rules() {
    return rules;
  }

  /** The unit propagation. Callers must undo their choices. */
  public Propagation propagation() {
    return propagation;
  }

  /** Whether the constraints are contradictory, so no row is allowed. */
  public boolean contradiction() {
    return contradiction;
  }

  /** Whether propagation covers all constraints. */
  public boolean propagatesAll() {
    return rules.complete();
  }

  /**
   * Completes a row. Unconstrained columns are not changed.
   *
   * @return an allowed row with the chosen cells; null if there is none
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

  /** Remembers an allowed row. Its unconstrained columns may be free. */
  public void witness(Row row) {
    if (rules.isEmpty()) {
      return;
    }
    int word = known >>> 6;
    for (int c = 0; c < symbols.columns(); c++) {
      if (!rules.isConstrained(c)) {
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

  /** Whether an allowed row can contain these values. */
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
      if (rules.isConstrained(columns[i])) {
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
