package org.sitaf.core.combine.feasible;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;

/** All rules of a problem. */
public final class Rules {
  private final Symbols symbols;
  private final List<Rule> all = new ArrayList<>();
  private final Rule[][] through;
  private final boolean tabulated;

  /** Creates the rules of constraints. */
  public Rules(Symbols symbols, List<Constraint> constraints) {
    this.symbols = symbols;
    List<List<Rule>> lists = new ArrayList<>();
    for (int c = 0; c < symbols.columns(); c++) {
      lists.add(new ArrayList<>());
    }
    for (Constraint constraint : constraints) {
      Rule rule = new Rule(symbols, constraint);
      all.add(rule);
      for (int c : rule.columns) {
        lists.get(c).add(rule);
      }
    }
    this.through = lists.stream().map(l -> l.toArray(Rule[]::new)).toArray(Rule[][]::new);
    this.tabulated = all.stream().allMatch(Rule::tabulated);
  }

  /** Whether there are no rules. */
  public boolean isEmpty() {
    return all.isEmpty();
  }

  /** Whether a column is constrained. */
  public boolean isConstrained(int column) {
    return through[column].length > 0;
  }

  /** Whether {@link #forbidden} contains all forbidden tuples. */
  boolean complete() {
    return tabulated;
  }

  /** The forbidden sets of symbols of all tabulated rules. */
  List<int[]> forbidden() {
    List<int[]> sets = new ArrayList<>();
    for (Rule rule : all) {
      sets.addAll(rule.forbidden(symbols));
    }
    return sets;
  }

  /** Whether a row violates no rule. Rules with free cells are not violated. */
  public boolean allow(Row row) {
    for (Rule rule : all) {
      if (!rule.isSatisfied(row)) {
        return false;
      }
    }
    return true;
  }

  /** Whether an allowed row remains allowed with another value in a column. */
  public boolean allow(Row row, int column, int value) {
    for (Rule rule : through[column]) {
      if (!rule.isSatisfied(row, column, value)) {
        return false;
      }
    }
    return true;
  }

  /**
   * For each rule that a complete row violates, the cells of the row as a set of symbols.
   *
   * @throws org.sitaf.core.combine.WideConstraintException if a rule is violated too often
   */
  List<int[]> violations(Row row) {
    List<int[]> sets = new ArrayList<>();
    for (Rule rule : all) {
      if (!rule.isSatisfied(row)) {
        rule.learn();
        sets.add(Arrays.stream(rule.columns).map(c -> symbols.symbol(c, row.value(c))).toArray());
      }
    }
    return sets;
  }
}
