package org.sitaf.core.combine.feasible;

import java.math.BigInteger;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sat4j.core.VecInt;
import org.sat4j.minisat.SolverFactory;
import org.sat4j.specs.ContradictionException;
import org.sat4j.specs.IConstr;
import org.sat4j.specs.ISolver;
import org.sat4j.specs.ISolverService;
import org.sat4j.specs.SearchListenerAdapter;
import org.sat4j.specs.TimeoutException;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.combine.TooManyCombinationsException;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;

/**
 * A SAT solver with one variable per symbol of a constrained column. Rules without a table are
 * learned: whenever a solution violates one, the violating tuple is added as a clause.
 */
final class Solver {
  /** Maximum number of conflicts in all searches together; takes some minutes. */
  private static final int MAX_CONFLICTS = 2_000_000;

  private final Symbols symbols;
  private final Rules rules;
  private final ISolver sat = SolverFactory.newDefault();
  private final int[] constrained;
  private boolean contradiction;

  Solver(Symbols symbols, Rules rules, List<int[]> forbidden) {
    this.symbols = symbols;
    this.rules = rules;
    this.constrained =
        java.util.stream.IntStream.range(0, symbols.columns())
            .filter(rules::isConstrained)
            .toArray();
    // With a timeout in seconds, Sat4j would start a timer thread for each search.
    sat.setTimeoutOnConflicts(Integer.MAX_VALUE);
    sat.setSearchListener(new Watch());
    sat.newVar(symbols.count());
    try {
      for (int c : constrained) {
        VecInt any = new VecInt();
        for (int s = symbols.first(c); s < symbols.first(c + 1); s++) {
          any.push(s + 1);
        }
        sat.addExactly(any, 1);
      }
      for (int[] set : forbidden) {
        forbid(set);
      }
    } catch (ContradictionException e) {
      contradiction = true;
    }
  }

  /** Stops a search that takes too long. */
  private static final class Watch extends SearchListenerAdapter<ISolverService> {
    private static final long serialVersionUID = 1L;

    private int conflicts;

    @Override
    public void conflictFound(IConstr conflict, int level, int trailLevel) {
      Interruption.check();
      if (++conflicts > MAX_CONFLICTS) {
        throw new TooManyCombinationsException(
            "number of conflicts in the search for cases that satisfy all conditions",
            BigInteger.valueOf(conflicts),
            MAX_CONFLICTS);
      }
    }
  }

  private void forbid(int[] set) throws ContradictionException {
    VecInt clause = new VecInt();
    for (int s : set) {
      clause.push(-(s + 1));
    }
    sat.addClause(clause);
  }

  /**
   * Completes a row. Unconstrained columns are not changed.
   *
   * @return an allowed row with the chosen cells; null if there is none
   */
  @Nullable Row complete(Row partial) {
    VecInt assumptions = new VecInt();
    for (int c : constrained) {
      if (partial.value(c) != Row.FREE) {
        assumptions.push(symbols.symbol(c, partial.value(c)) + 1);
      }
    }
    try {
      while (!contradiction && sat.isSatisfiable(assumptions)) {
        Row row = new Row(symbols, partial.values());
        int[] model = sat.model();
        for (int literal : model) {
          if (literal > 0 && literal <= symbols.count()) {
            int column = symbols.column(literal - 1);
            if (rules.isConstrained(column)) {
              row.set(column, symbols.value(literal - 1));
            }
          }
        }
        List<int[]> violations = rules.violations(row);
        if (violations.isEmpty()) {
          return row;
        }
        for (int[] set : violations) {
          forbid(set);
        }
      }
    } catch (ContradictionException e) {
      contradiction = true;
    } catch (TimeoutException e) {
      throw new IllegalStateException("timeout of a solver without time limit", e);
    }
    return null;
  }
}
