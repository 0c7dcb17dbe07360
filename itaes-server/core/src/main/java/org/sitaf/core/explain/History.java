package org.sitaf.core.explain;

import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.sitaf.core.combine.Interruption;

/** The executed rows, of the suite and beyond it. */
final class History {
  private final Combinations combinations;
  private final Combinations.Execution execution;
  private final int budget;
  private final List<int[]> passing = new ArrayList<>();
  private final List<int[]> passingValid = new ArrayList<>();
  private final List<Combinations.Row> failing = new ArrayList<>();
  // For lookups: a search checks thousands of candidates, and a suite can have 100,000 rows.
  private final Set<IntBuffer> passed = new HashSet<>();
  private final Set<IntBuffer> failed = new HashSet<>();
  // How many of the passing rows, from the first one, are known not to refute a tuple.
  private final Map<Tuple, Integer> withoutTuple = new HashMap<>();

  private final List<Predicate<int[]>> relations = new ArrayList<>();
  private int executions;

  History(Combinations combinations, Combinations.Execution execution, int budget) {
    this.combinations = combinations;
    this.execution = execution;
    this.budget = budget;
    combinations.executed().forEach(this::add);
  }

  private void add(Combinations.Row row) {
    int[] values = row.values();
    if (row.outcome().failed()) {
      failing.add(row);
      failed.add(IntBuffer.wrap(values));
    } else {
      passing.add(values);
      passed.add(IntBuffer.wrap(values));
      if (combinations.invalidOf(values) == 0) {
        passingValid.add(values);
      }
    }
  }

  Combinations combinations() {
    return combinations;
  }

  List<int[]> passing() {
    return passing;
  }

  /** The passing rows without an invalid value. */
  List<int[]> passingValid() {
    return Collections.unmodifiableList(passingValid);
  }

  /** Whether a row has an invalid value that another one does not have. */
  boolean addsInvalid(int[] row, int[] other) {
    return (combinations.invalidOf(row) & ~agreement(row, other)) != 0;
  }

  List<Combinations.Row> failing() {
    return failing;
  }

  /** The number of executions beyond the suite. */
  int executions() {
    return executions;
  }

  boolean isExhausted() {
    return executions >= budget;
  }

  /** Executes a row, also one that was executed before. */
  Outcome execute(int[] row) throws InterruptedException {
    Interruption.check();
    Outcome outcome = execution.execute(row.clone());
    executions++;
    add(new Combinations.Row(row.clone(), outcome));
    return outcome;
  }

  boolean wasExecuted(int[] row) {
    IntBuffer values = IntBuffer.wrap(row);
    return passed.contains(values) || failed.contains(values);
  }

  /** Whether a row failed once and passed another time. */
  boolean isFlaky(int[] row) {
    return passed.contains(IntBuffer.wrap(row));
  }

  /** The number of different rows that failed once and passed another time. */
  long flakyRows() {
    return failing.stream()
        .map(Combinations.Row::values)
        .filter(this::isFlaky)
        .map(f -> Arrays.stream(f).boxed().toList())
        .distinct()
        .count();
  }

  /** How many executions failed with a tuple. */
  int confirmations(Tuple tuple) {
    return (int) failing.stream().filter(f -> tuple.isIn(f.values())).count();
  }

  /** Whether a case with the tuple passed. */
  boolean isRefuted(Tuple tuple) {
    for (int i = withoutTuple.getOrDefault(tuple, 0); i < passing.size(); i++) {
      int[] row = passing.get(i);
      if (tuple.isIn(row) && (combinations.invalidOf(row) & ~tuple.mask()) == 0) {
        return true;
      }
    }
    withoutTuple.put(tuple, passing.size());
    return false;
  }

  /** Adds a relation that explains the rows that fulfil it. */
  void explain(Predicate<int[]> relation) {
    relations.add(relation);
  }

  /** Removes all relations. */
  void explainNothing() {
    relations.clear();
  }

  /** Whether a relation explains a row. */
  boolean isExplained(int[] row) {
    return relations.stream().anyMatch(r -> r.test(row));
  }

  /** The parameters in which two rows agree, one bit for each. */
  static long agreement(int[] a, int[] b) {
    long mask = 0;
    for (int i = 0; i < a.length; i++) {
      if (a[i] == b[i]) {
        mask |= 1L << i;
      }
    }
    return mask;
  }
}
