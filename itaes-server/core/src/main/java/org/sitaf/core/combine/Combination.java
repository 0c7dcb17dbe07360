package org.sitaf.core.combine;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import org.sitaf.core.combine.CoveringArray.TupleReport;
import org.sitaf.core.combine.construction.Constructions;
import org.sitaf.core.combine.construction.Constructions.Development;
import org.sitaf.core.combine.coverage.ColumnSets;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Dice;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;
import org.sitaf.core.combine.feasible.ImpossibleTuples;
import org.sitaf.core.combine.feasible.ImpossibleTuples.Judgement;
import org.sitaf.core.combine.search.Budget;
import org.sitaf.core.combine.search.Greedy;
import org.sitaf.core.combine.search.TupleForcing;

/** One combination, from what is possible over a first array to a small one. */
final class Combination {
  /** Within this factor of the bound, growth need not compete. */
  private static final double NEAR = 1.1;

  private final CombinationProblem problem;
  private final Symbols symbols;
  private final List<int[]> sets;
  private final Feasibility feasibility;
  private final Effort effort;
  private final Progress progress;

  Combination(
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

  CoveringArray run(long seed) {
    Coverage coverage = ColumnSets.coverage(symbols, sets);
    Judgement judgement = ImpossibleTuples.exclude(symbols, sets, feasibility, coverage);
    TupleReport report = judgement.report();
    long most = TestDataCombinator.maxRows(symbols);
    if (judgement.bound() > most) {
      throw new TooManyCombinationsException(
          "cases that are needed at least", BigInteger.valueOf(judgement.bound()), most);
    }
    Dice dice = new Dice(seed);
    Budget budget = new Budget(operations());
    Greedy greedy = new Greedy(symbols, coverage, feasibility, dice, budget);

    List<Row> rows = new ArrayList<>();
    List<int[]> kept = problem.seeds();
    for (int[] values : kept) {
      Row filled =
          Objects.requireNonNull(
              greedy.fill(new Row(symbols, values)), "a seed that was found allowed");
      filled.keep(values);
      coverage.add(filled);
      rows.add(filled);
    }
    boolean plain = kept.isEmpty() && feasibility.rules().isEmpty();
    Optional<Plain> columns = plain ? Plain.of(problem, symbols) : Optional.empty();
    first(rows, columns.flatMap(Plain::atOnce), judgement.bound(), coverage, greedy);
    if (rows.isEmpty()) {
      Row only = greedy.fill(new Row(symbols));
      if (only != null) {
        coverage.add(only);
        rows.add(only);
      }
    }
    progress.report(rows.size(), 0);

    int enough = Math.max(judgement.bound(), kept.size());
    List<int[]> best = rows.stream().map(Row::values).toList();
    if (effort != Effort.FAST) {
      best = smaller(rows, best, enough, columns, coverage, greedy, dice, budget);
    }
    return new CoveringArray(ordered(best, kept.size()), report, best.size() <= enough, List.of());
  }

  /** A first complete array: what algebra gives where that is near the bound, or else smaller. */
  private void first(
      List<Row> rows, Optional<List<int[]>> algebra, int bound, Coverage coverage, Greedy greedy) {
    int tries = effort == Effort.FAST ? 1 : 4;
    if (algebra.isPresent() && algebra.get().size() <= NEAR * bound) {
      replace(rows, algebra.get(), coverage);
    }
    greedy.grow(rows, tries, Integer.MAX_VALUE);
    if (algebra.isPresent() && algebra.get().size() < rows.size()) {
      replace(rows, algebra.get(), coverage);
      greedy.grow(rows, tries, Integer.MAX_VALUE);
    }
  }

  private List<int[]> smaller(
      List<Row> rows,
      List<int[]> complete,
      int enough,
      Optional<Plain> columns,
      Coverage coverage,
      Greedy greedy,
      Dice dice,
      Budget budget) {
    TupleForcing search = new TupleForcing(symbols, coverage, feasibility, greedy, dice, rows);
    List<int[]> best = search.shrink(complete, enough, budget.part(0.1), listener(budget));
    if (best.size() > enough && columns.isPresent()) {
      Development found = columns.get().developed(best.size(), dice, budget.part(0.3));
      if (found.array().isPresent()) {
        replace(rows, found.array().get(), coverage);
        greedy.grow(rows, 1, Integer.MAX_VALUE);
        best = rows.stream().map(Row::values).toList();
        progress.report(best.size(), budget.share());
      }
      if (found.nearMiss().isPresent()) {
        replace(rows, found.nearMiss().get(), coverage);
        greedy.grow(rows, 4, best.size() - 1);
        best = search.shrink(best, enough, budget.part(0.3), listener(budget));
      }
      replace(rows, best, coverage);
    }
    return search.shrink(best, enough, budget.patient(patience()), listener(budget));
  }

  private TupleForcing.Listener listener(Budget budget) {
    return n -> progress.report(n, budget.share());
  }

  private void replace(List<Row> rows, List<int[]> by, Coverage coverage) {
    rows.forEach(coverage::remove);
    rows.clear();
    for (int[] values : by) {
      Row row = new Row(symbols, values);
      coverage.add(row);
      rows.add(row);
    }
  }

  /** The varied columns of a problem with a single interaction, for which algebra may know. */
  private record Plain(Symbols symbols, int strength, int[] columns, int[] levels) {
    static Optional<Plain> of(CombinationProblem problem, Symbols symbols) {
      if (problem.interactions().size() != 1) {
        return Optional.empty();
      }
      Interaction interaction = problem.interactions().get(0);
      int[] columns =
          Arrays.stream(interaction.parameters()).filter(c -> symbols.levels(c) > 1).toArray();
      int[] levels = Arrays.stream(columns).map(symbols::levels).toArray();
      int strength = Math.min(interaction.strength(), columns.length);
      return Optional.of(new Plain(symbols, strength, columns, levels));
    }

    Optional<List<int[]>> atOnce() {
      return Constructions.atOnce(strength, levels).map(this::whole);
    }

    Development developed(int size, Dice dice, Budget budget) {
      Development found = Constructions.developed(strength, levels, size, dice, budget);
      return new Development(found.array().map(this::whole), found.nearMiss().map(this::whole));
    }

    private List<int[]> whole(List<int[]> rows) {
      List<int[]> whole = new ArrayList<>();
      for (int[] row : rows) {
        int[] values = new int[symbols.columns()];
        for (int i = 0; i < columns.length; i++) {
          values[columns[i]] = row[i];
        }
        whole.add(values);
      }
      return whole;
    }
  }

  /** By default a search that finds nothing for a while gives up: a person waits. */
  private double patience() {
    return effort == Effort.DEFAULT && !onlyPairs() ? 0.3 : 1;
  }

  private boolean onlyPairs() {
    return sets.stream().allMatch(set -> set.length <= 2);
  }

  private long operations() {
    return switch (effort) {
      case FAST -> 0;
      case DEFAULT -> onlyPairs() ? 900_000_000L : 9_000_000_000L;
      case BEST -> 85_000_000_000L;
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
