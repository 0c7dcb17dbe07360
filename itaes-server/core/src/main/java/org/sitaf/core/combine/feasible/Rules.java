package org.sitaf.core.combine.feasible;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;

/** All constraints of a problem. */
public final class Rules {
  private final Symbols symbols;
  private final List<Rule> all = new ArrayList<>();
  private final Rule[][] through;
  private final boolean tabulated;

  /** The constraints, tabulated where they are small enough. */
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

  /** Whether there is none. */
  public boolean isEmpty() {
    return all.isEmpty();
  }

  /** Whether this column takes part in any. */
  public boolean touches(int column) {
    return through[column].length > 0;
  }

  /** Whether every forbidden tuple is in {@link #forbidden}. */
  boolean complete() {
    return tabulated;
  }

  /** The forbidden sets of symbols of all constraints that could be tabulated. */
  List<int[]> forbidden() {
    List<int[]> sets = new ArrayList<>();
    for (Rule rule : all) {
      sets.addAll(rule.forbidden(symbols));
    }
    return sets;
  }

  /** Whether a row, perhaps with free cells, breaks none of those that it decides. */
  public boolean allow(Row row) {
    for (Rule rule : all) {
      if (!rule.keeps(row)) {
        return false;
      }
    }
    return true;
  }

  /** Whether an allowed row stays allowed with this value in this column. */
  public boolean allow(Row row, int column, int value) {
    for (Rule rule : through[column]) {
      if (!rule.keeps(row, column, value)) {
        return false;
      }
    }
    return true;
  }

  /**
   * For each constraint that a complete row breaks, its cells as a set of symbols.
   *
   * @throws org.sitaf.core.combine.WideConstraintException when a constraint breaks too often
   */
  List<int[]> broken(Row row) {
    List<int[]> sets = new ArrayList<>();
    for (Rule rule : all) {
      if (!rule.keeps(row)) {
        rule.learn();
        sets.add(Arrays.stream(rule.columns).map(c -> symbols.symbol(c, row.value(c))).toArray());
      }
    }
    return sets;
  }
}
