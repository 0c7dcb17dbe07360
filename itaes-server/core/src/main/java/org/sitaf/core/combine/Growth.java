package org.sitaf.core.combine;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.CoveringArray.TupleReport;
import org.sitaf.core.combine.coverage.ColumnSets;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Row;
import org.sitaf.core.combine.coverage.Symbols;
import org.sitaf.core.combine.feasible.Feasibility;
import org.sitaf.core.combine.feasible.ImpossibleTuples;
import org.sitaf.core.combine.search.Budget;
import org.sitaf.core.combine.search.Greedy;

/** Grows an array of a bounded number of rows: each value first, then as many tuples as fit. */
final class Growth {
  /** Number of candidates for each row. */
  private static final int TRIES = 10;

  /** Number of preferred values that are tried for a row. */
  private static final int PREFERRED_TRIES = 3;

  private final CombinationProblem problem;
  private final Symbols symbols;
  private final List<int[]> sets;
  private final Feasibility feasibility;
  private final SeededRandom random;
  private final Coverage coverage;
  private final TupleReport report;
  private final Greedy greedy;

  Growth(
      CombinationProblem problem,
      Symbols symbols,
      List<int[]> sets,
      Feasibility feasibility,
      long seed) {
    this.problem = problem;
    this.symbols = symbols;
    this.sets = sets;
    this.feasibility = feasibility;
    this.random = new SeededRandom(seed);
    this.coverage = ColumnSets.coverage(symbols, sets);
    this.report = ImpossibleTuples.exclude(symbols, sets, feasibility, coverage).report();
    this.greedy = new Greedy(symbols, coverage, feasibility, random, new Budget(0));
  }

  /**
   * Grows the array.
   *
   * @param limit maximum number of rows; more are returned only if more are needed
   * @param eachValue whether each possible value must occur
   * @param preferred values of which every second row holds one, unless it would cover fewer tuples
   */
  GrownArray grow(int limit, boolean eachValue, List<ParameterValue> preferred, Progress progress) {
    List<Row> rows = new ArrayList<>();
    List<Long> covered = new ArrayList<>();
    for (int[] values : problem.seeds()) {
      add(Objects.requireNonNull(greedy.fill(new Row(symbols, values))), rows, covered);
    }
    if (eachValue) {
      addEachValue(rows, covered);
    }
    if (rows.isEmpty()) {
      int before = rows.size();
      if (coverage.uncovered() > 0) {
        greedy.grow(rows, TRIES, 1);
      } else {
        Row only = greedy.fill(new Row(symbols));
        if (only != null) {
          coverage.add(only);
          rows.add(only);
        }
      }
      if (rows.size() > before) {
        covered.add(coverage.required() - coverage.uncovered());
      }
    }
    int needed = rows.size();
    Deque<ParameterValue> next = new ArrayDeque<>(preferred);
    while (rows.size() < limit && coverage.uncovered() > 0) {
      Interruption.check();
      int before = coverage.uncovered();
      greedy.grow(rows, TRIES, rows.size() + 1);
      if ((rows.size() - needed) % 2 == 1) {
        preferNext(next, before - coverage.uncovered(), rows);
      }
      covered.add(coverage.required() - coverage.uncovered());
      progress.report(rows.size(), (double) rows.size() / limit);
    }
    return new GrownArray(
        rows.stream().map(Row::values).toArray(int[][]::new),
        needed,
        covered.stream().mapToLong(Long::longValue).toArray(),
        report,
        List.of());
  }

  /**
   * Replaces the last row by one with the next preferred value, if one covers as many tuples.
   *
   * @param gain number of tuples that only the last row covers
   */
  private void preferNext(Deque<ParameterValue> values, int gain, List<Row> rows) {
    Row last = rows.get(rows.size() - 1);
    coverage.remove(last);
    for (int left = Math.min(values.size(), PREFERRED_TRIES); left > 0; left--) {
      ParameterValue value = values.removeFirst();
      Row row = holding(value, gain);
      values.addLast(value);
      if (row != null) {
        coverage.add(row);
        rows.set(rows.size() - 1, row);
        return;
      }
    }
    coverage.add(last);
  }

  /** A row with a value that covers at least so many tuples, some of them with this value. */
  private @Nullable Row holding(ParameterValue value, int gain) {
    for (int i = 0; i < TRIES; i++) {
      Row partial = new Row(symbols);
      partial.set(value.parameter(), value.value());
      Row row = greedy.fill(partial);
      if (row != null && coverage.gain(row, value.parameter(), value.value()) > 0) {
        int before = coverage.uncovered();
        coverage.add(row);
        int covered = before - coverage.uncovered();
        coverage.remove(row);
        if (covered >= gain) {
          return row;
        }
      }
    }
    return null;
  }

  private void add(Row row, List<Row> rows, List<Long> covered) {
    coverage.add(row);
    rows.add(row);
    covered.add(coverage.required() - coverage.uncovered());
  }

  /** Adds rows until each possible value occurs; their other cells cover many tuples. */
  private void addEachValue(List<Row> rows, List<Long> covered) {
    List<int[]> columns =
        IntStream.range(0, symbols.columns())
            .filter(c -> symbols.levels(c) > 1)
            .mapToObj(c -> new int[] {c})
            .toList();
    if (columns.isEmpty()) {
      return;
    }
    Coverage values = ColumnSets.coverage(symbols, columns);
    var unused = ImpossibleTuples.exclude(symbols, columns, feasibility, values);
    rows.forEach(values::add);
    int[] order = columns.stream().mapToInt(column -> column[0]).toArray();
    while (values.uncovered() > 0) {
      Interruption.check();
      Coverage.Tuple first = values.pick(random);
      Row partial = new Row(symbols);
      partial.set(first.columns()[0], first.values()[0]);
      random.shuffle(order);
      for (int column : order) {
        if (partial.value(column) == Row.FREE) {
          chooseMissing(partial, column, values);
        }
      }
      Row row =
          Objects.requireNonNull(greedy.fill(partial), "the partial row was completed before");
      values.add(row);
      add(row, rows, covered);
    }
  }

  /** Chooses a value that does not occur yet, if there is one that the constraints allow. */
  private void chooseMissing(Row partial, int column, Coverage values) {
    int levels = symbols.levels(column);
    int start = random.nextInt(levels);
    for (int i = 0; i < levels; i++) {
      int value = (start + i) % levels;
      if (values.gain(partial, column, value) > 0) {
        partial.set(column, value);
        if (feasibility.rules().isEmpty() || feasibility.complete(partial) != null) {
          return;
        }
        partial.set(column, Row.FREE);
      }
    }
  }

  /** The losses of the given rows, which are the only ones. */
  GrownArray.Losses losses(List<int[]> rows) {
    rows.forEach(values -> coverage.add(new Row(symbols, values)));
    Map<GrownArray.Pair, long[]> byPair = new HashMap<>();
    for (int[] set : sets) {
      long[] counts = count(set);
      for (int i = 0; i < set.length; i++) {
        for (int j = i + 1; j < set.length; j++) {
          long[] sum =
              byPair.computeIfAbsent(new GrownArray.Pair(set[i], set[j]), pair -> new long[2]);
          sum[0] += counts[0];
          sum[1] += counts[1];
        }
      }
    }
    Map<GrownArray.Pair, GrownArray.Loss> losses = new HashMap<>();
    byPair.forEach(
        (pair, sum) -> {
          if (sum[0] > 0) {
            losses.put(pair, new GrownArray.Loss(sum[0], sum[1]));
          }
        });
    return new GrownArray.Losses(losses);
  }

  /** The number of uncovered and of all tuples of a set; impossible ones only in the latter. */
  private long[] count(int[] set) {
    long[] counts = new long[2];
    int last = set.length - 1;
    int[] values = new int[set.length];
    int[] gains = new int[symbols.levels(set[last])];
    while (true) {
      Interruption.check();
      Row row = new Row(symbols);
      for (int i = 0; i < last; i++) {
        row.set(set[i], values[i]);
      }
      for (int v = 0; v < gains.length; v++) {
        row.set(set[last], v);
        counts[0] += coverage.gain(row, set[last], v) > 0 ? 1 : 0;
        counts[1]++;
      }
      int i = last - 1;
      while (i >= 0 && values[i] == symbols.levels(set[i]) - 1) {
        values[i--] = 0;
      }
      if (i < 0) {
        return counts;
      }
      values[i]++;
    }
  }
}
