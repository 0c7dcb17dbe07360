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
 * The judge of what is possible: a SAT solver with one variable per symbol of a constrained column.
 * A constraint too large for a table is learned by its broken tuples, as solutions break it.
 */
final class Solver {
  /** Conflicts of all questions together: some minutes. */
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
        java.util.stream.IntStream.range(0, symbols.columns()).filter(rules::touches).toArray();
    // By conflicts: by time, Sat4j would start a timer thread for each question.
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

  /** Ends a search that takes too long. */
  private static final class Watch extends SearchListenerAdapter<ISolverService> {
    private static final long serialVersionUID = 1L;

    private int conflicts;

    @Override
    public void conflictFound(IConstr conflict, int level, int trailLevel) {
      Interruption.check();
      if (++conflicts > MAX_CONFLICTS) {
        throw new TooManyCombinationsException(
            "conflicts met in the search for cases that keep all conditions",
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
   * Finds an allowed row that agrees with the chosen cells; unconstrained columns stay as they are.
   *
   * @return null where there is none
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
            if (rules.touches(column)) {
              row.set(column, symbols.value(literal - 1));
            }
          }
        }
        List<int[]> broken = rules.broken(row);
        if (broken.isEmpty()) {
          return row;
        }
        for (int[] set : broken) {
          forbid(set);
        }
      }
    } catch (ContradictionException e) {
      contradiction = true;
    } catch (TimeoutException e) {
      throw new IllegalStateException("the solver gave up although it has no time limit", e);
    }
    return null;
  }
}
