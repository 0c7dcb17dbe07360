package org.sitaf.core.combine.feasible;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.combine.CoveringArray.Tuple;
import org.sitaf.core.combine.CoveringArray.TupleReport;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.combine.coverage.Coverage;
import org.sitaf.core.combine.coverage.Symbols;

/** Finds required tuples that the constraints exclude, and removes them from a coverage. */
public final class ImpossibleTuples {
  private final Symbols symbols;
  private final Feasibility feasibility;
  private final Coverage coverage;
  private final List<Tuple> examples = new ArrayList<>();
  private long count;

  /** The impossible tuples of each set of constrained columns. */
  private final Map<List<Integer>, List<int[]>> judged = new HashMap<>();

  private ImpossibleTuples(Symbols symbols, Feasibility feasibility, Coverage coverage) {
    this.symbols = symbols;
    this.feasibility = feasibility;
    this.coverage = coverage;
  }

  /**
   * The result of the exclusion.
   *
   * @param report the remaining and the excluded tuples
   * @param bound lower bound of the number of rows: the maximum number of remaining tuples of a
   *     column set, since a row covers only one of them
   */
  public record Exclusion(TupleReport report, int bound) {}

  /** Excludes the impossible tuples of column sets. */
  public static Exclusion exclude(
      Symbols symbols, List<int[]> sets, Feasibility feasibility, Coverage coverage) {
    var judge = new ImpossibleTuples(symbols, feasibility, coverage);
    long bound = 1;
    for (int[] set : sets) {
      long tuples = 1;
      for (int column : set) {
        tuples *= symbols.levels(column);
      }
      long before = judge.count;
      Interruption.check();
      if (!feasibility.rules().isEmpty()) {
        judge.judge(set);
      }
      bound = Math.max(bound, tuples - (judge.count - before));
    }
    TupleReport report = new TupleReport(coverage.required(), judge.count, judge.examples);
    return new Exclusion(report, (int) bound);
  }

  private void judge(int[] set) {
    int[] constrained = Arrays.stream(set).filter(feasibility.rules()::isConstrained).toArray();
    if (constrained.length == 0 && !feasibility.contradiction()) {
      return;
    }
    List<int[]> impossible =
        constrained.length == set.length
            ? impossible(constrained)
            : judged.computeIfAbsent(
                Arrays.stream(constrained).boxed().toList(), key -> impossible(constrained));
    for (int[] values : impossible) {
      int[] whole = new int[set.length];
      Arrays.fill(whole, -1);
      for (int i = 0, j = 0; i < set.length; i++) {
        if (j < constrained.length && set[i] == constrained[j]) {
          whole[i] = values[j++];
        }
      }
      exclude(set, whole, 0);
    }
  }

  private List<int[]> impossible(int[] columns) {
    List<int[]> found = new ArrayList<>();
    int[] values = new int[columns.length];
    while (true) {
      Interruption.check();
      if (!feasibility.possible(columns, values)) {
        found.add(values.clone());
      }
      int i = columns.length - 1;
      while (i >= 0 && values[i] == symbols.levels(columns[i]) - 1) {
        values[i--] = 0;
      }
      if (i < 0) {
        return found;
      }
      values[i]++;
    }
  }

  /** Excludes a tuple with all values at the unset positions. */
  private void exclude(int[] set, int[] values, int from) {
    for (int i = from; i < set.length; i++) {
      if (values[i] < 0) {
        for (int v = 0; v < symbols.levels(set[i]); v++) {
          values[i] = v;
          exclude(set, values, i + 1);
        }
        values[i] = -1;
        return;
      }
    }
    count++;
    coverage.exclude(set, values);
    if (examples.size() < TupleReport.MAX_EXAMPLES) {
      examples.add(new Tuple(set, values));
    }
  }
}
