package org.sitaf.core.combine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import org.sitaf.core.combine.CoveringArray.TupleReport;
import org.sitaf.core.combine.construction.Constructions;
import org.sitaf.core.combine.coverage.ColumnSets;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Dice;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;
import org.sitaf.core.combine.feasible.ImpossibleTuples;
import org.sitaf.core.combine.search.Budget;
import org.sitaf.core.combine.search.Greedy;
import org.sitaf.core.combine.search.TupleForcing;

/** One combination, from what is possible over a first array to a small one. */
final class Construction {
  private final CombinationProblem problem;
  private final Symbols symbols;
  private final List<int[]> sets;
  private final Feasibility feasibility;
  private final Effort effort;
  private final Progress progress;

  Construction(
      CombinationProblem problem,
      Symbols symbols,
      List<int[]> sets,
      Feasibility feasibility,
      Effort effort,
      Progress progress) {
    this.problem = problem;
    this.symbols = symbols;
    this.sets = sets;
    this.feasibility = feasibility;
    this.effort = effort;
    this.progress = progress;
  }

  CoveringArray run(List<Row> kept, long seed) {
    Coverage coverage = ColumnSets.coverage(symbols, sets);
    TupleReport report = ImpossibleTuples.exclude(symbols, sets, feasibility, coverage);
    int bound = bound(report);
    Dice dice = new Dice(seed);
    Budget budget = new Budget(operations());
    Greedy greedy = new Greedy(symbols, coverage, feasibility, dice, budget);

    List<Row> rows = new ArrayList<>();
    for (Row row : kept) {
      Row filled = greedy.fill(row);
      filled.keep(problem.seeds().get(rows.size()));
      coverage.add(filled);
      rows.add(filled);
    }
    addConstructed(rows, coverage);
    greedy.grow(rows, effort == Effort.FAST ? 1 : 4, Integer.MAX_VALUE);
    if (rows.isEmpty()) {
      Row only = greedy.fill(new Row(symbols));
      if (only != null) {
        coverage.add(only);
        rows.add(only);
      }
    }
    progress.report(rows.size(), 0);

    List<int[]> best = rows.stream().map(Row::values).toList();
    int enough = Math.max(bound, kept.size());
    if (effort != Effort.FAST && rows.size() > enough) {
      TupleForcing search =
          new TupleForcing(symbols, coverage, feasibility, greedy, dice, budget, rows);
      best = search.shrink(enough, n -> progress.report(n, budget.share()));
    }
    return new CoveringArray(ordered(best, kept.size()), report, best.size() <= enough);
  }

  /** Adds the rows of a construction where one exists that is near the bound. */
  private void addConstructed(List<Row> rows, Coverage coverage) {
    if (!rows.isEmpty() || !feasibility.rules().isEmpty()) {
      return;
    }
    if (problem.interactions().size() != 1) {
      return;
    }
    int[] columns =
        Arrays.stream(problem.interactions().get(0).parameters())
            .filter(c -> symbols.levels(c) > 1)
            .toArray();
    int[] levels = Arrays.stream(columns).map(symbols::levels).toArray();
    for (int[] values :
        Constructions.find(problem.interactions().get(0).strength(), levels).orElse(List.of())) {
      int[] whole = new int[symbols.columns()];
      for (int i = 0; i < columns.length; i++) {
        whole[columns[i]] = values[i];
      }
      Row row = new Row(symbols, whole);
      coverage.add(row);
      rows.add(row);
    }
  }

  /** No array has fewer rows than one set of columns has possible tuples. */
  private int bound(TupleReport report) {
    long most = 1;
    for (int[] set : sets) {
      long tuples = 1;
      for (int c : set) {
        tuples *= symbols.levels(c);
      }
      long impossible =
          report.impossible() == 0
              ? 0
              : report.examples().stream()
                  .filter(tuple -> Arrays.equals(tuple.parameters(), set))
                  .count();
      most = Math.max(most, tuples - impossible);
    }
    return (int) most;
  }

  private long operations() {
    boolean pairs = sets.stream().allMatch(set -> set.length <= 2);
    return switch (effort) {
      case FAST -> 0;
      case DEFAULT -> pairs ? 500_000_000L : 5_000_000_000L;
      case BEST -> 60_000_000_000L;
    };
  }

  /** Kept rows in their places, the others in ascending order, none twice. */
  private static int[][] ordered(List<int[]> rows, int kept) {
    List<int[]> all = new ArrayList<>(rows.subList(0, kept));
    TreeSet<int[]> others = new TreeSet<>(Comparator.comparing((int[] a) -> a, Arrays::compare));
    others.addAll(rows.subList(kept, rows.size()));
    all.forEach(others::remove);
    all.addAll(others);
    return all.toArray(int[][]::new);
  }
}
