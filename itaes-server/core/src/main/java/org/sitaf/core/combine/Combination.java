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
import org.sitaf.core.combine.construction.Constructions.SearchResult;
import org.sitaf.core.combine.coverage.ColumnSets;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;
import org.sitaf.core.combine.feasible.ImpossibleTuples;
import org.sitaf.core.combine.feasible.ImpossibleTuples.Exclusion;
import org.sitaf.core.combine.search.Budget;
import org.sitaf.core.combine.search.Greedy;
import org.sitaf.core.combine.search.TupleForcing;

/**
 * Runs one combination: excludes impossible tuples, creates a first covering array, then removes
 * rows from it.
 */
final class Combination {
  /**
   * An algebraic array within this factor of the lower bound is used without trying greedy growth.
   */
  private static final double NEAR_BOUND_FACTOR = 1.1;

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
    Exclusion exclusion = ImpossibleTuples.exclude(symbols, sets, feasibility, coverage);
    TupleReport report = exclusion.report();
    long maxRows = TestDataCombinator.maxRows(symbols);
    if (exclusion.bound() > maxRows) {
      throw new TooManyCombinationsException(
          "minimum number of cases", BigInteger.valueOf(exclusion.bound()), maxRows);
    }
    SeededRandom random = new SeededRandom(seed);
    Budget budget = new Budget(operations());
    Greedy greedy = new Greedy(symbols, coverage, feasibility, random, budget);

    List<Row> rows = new ArrayList<>();
    List<int[]> seeds = problem.seeds();
    for (int[] values : seeds) {
      Row filled =
          Objects.requireNonNull(greedy.fill(new Row(symbols, values)), "seed was checked before");
      filled.keep(values);
      coverage.add(filled);
      rows.add(filled);
    }
    boolean plain = seeds.isEmpty() && feasibility.rules().isEmpty();
    Optional<SingleInteraction> columns =
        plain ? SingleInteraction.of(problem, symbols) : Optional.empty();
    createFirst(
        rows, columns.flatMap(SingleInteraction::direct), exclusion.bound(), coverage, greedy);
    if (rows.isEmpty()) {
      Row only = greedy.fill(new Row(symbols));
      if (only != null) {
        coverage.add(only);
        rows.add(only);
      }
    }
    progress.report(rows.size(), 0);

    int targetSize = Math.max(exclusion.bound(), seeds.size());
    List<int[]> best = rows.stream().map(Row::values).toList();
    if (effort != Effort.FAST) {
      best = shrink(rows, best, targetSize, columns, coverage, greedy, random, budget);
    }
    return new CoveringArray(
        ordered(best, seeds.size()), report, best.size() <= targetSize, List.of());
  }

  /**
   * Creates a first complete array: the algebraic one if it is close to the lower bound or smaller
   * than the greedy one.
   */
  private void createFirst(
      List<Row> rows, Optional<List<int[]>> algebra, int bound, Coverage coverage, Greedy greedy) {
    int tries = effort == Effort.FAST ? 1 : 4;
    if (algebra.isPresent() && algebra.get().size() <= NEAR_BOUND_FACTOR * bound) {
      replace(rows, algebra.get(), coverage);
    }
    greedy.grow(rows, tries, Integer.MAX_VALUE);
    if (algebra.isPresent() && algebra.get().size() < rows.size()) {
      replace(rows, algebra.get(), coverage);
      greedy.grow(rows, tries, Integer.MAX_VALUE);
    }
  }

  private List<int[]> shrink(
      List<Row> rows,
      List<int[]> complete,
      int targetSize,
      Optional<SingleInteraction> columns,
      Coverage coverage,
      Greedy greedy,
      SeededRandom random,
      Budget budget) {
    TupleForcing search = new TupleForcing(symbols, coverage, feasibility, greedy, random, rows);
    List<int[]> best = search.shrink(complete, targetSize, budget.part(0.1), listener(budget));
    if (best.size() > targetSize && columns.isPresent()) {
      SearchResult found = columns.get().develop(best.size(), random, budget.part(0.3));
      if (found.array().isPresent()) {
        replace(rows, found.array().get(), coverage);
        greedy.grow(rows, 1, Integer.MAX_VALUE);
        best = rows.stream().map(Row::values).toList();
        progress.report(best.size(), budget.share());
      }
      if (found.nearMiss().isPresent()) {
        replace(rows, found.nearMiss().get(), coverage);
        greedy.grow(rows, 4, best.size() - 1);
        best = search.shrink(best, targetSize, budget.part(0.3), listener(budget));
      }
      replace(rows, best, coverage);
    }
    return search.shrink(best, targetSize, budget.withStallLimit(stallLimit()), listener(budget));
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

  /**
   * The columns with more than one value of a problem with a single interaction, to which algebraic
   * constructions apply.
   */
  private record SingleInteraction(Symbols symbols, int strength, int[] columns, int[] levels) {
    static Optional<SingleInteraction> of(CombinationProblem problem, Symbols symbols) {
      if (problem.interactions().size() != 1) {
        return Optional.empty();
      }
      Interaction interaction = problem.interactions().get(0);
      int[] columns =
          Arrays.stream(interaction.parameters()).filter(c -> symbols.levels(c) > 1).toArray();
      int[] levels = Arrays.stream(columns).map(symbols::levels).toArray();
      int strength = Math.min(interaction.strength(), columns.length);
      return Optional.of(new SingleInteraction(symbols, strength, columns, levels));
    }

    Optional<List<int[]>> direct() {
      return Constructions.direct(strength, levels).map(this::toFullRows);
    }

    SearchResult develop(int size, SeededRandom random, Budget budget) {
      SearchResult found = Constructions.develop(strength, levels, size, random, budget);
      return new SearchResult(
          found.array().map(this::toFullRows), found.nearMiss().map(this::toFullRows));
    }

    private List<int[]> toFullRows(List<int[]> rows) {
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

  /**
   * With default effort, the search stops early if it makes no progress, because a user is waiting.
   */
  private double stallLimit() {
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

  /** Seeds first, then the others in ascending order without duplicates. */
  private static int[][] ordered(List<int[]> rows, int seedCount) {
    List<int[]> all = new ArrayList<>(rows.subList(0, seedCount));
    TreeSet<int[]> others = new TreeSet<>(Comparator.comparing((int[] a) -> a, Arrays::compare));
    others.addAll(rows.subList(seedCount, rows.size()));
    all.forEach(others::remove);
    all.addAll(others);
    return all.toArray(int[][]::new);
  }
}
