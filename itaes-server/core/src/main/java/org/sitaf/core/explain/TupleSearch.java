package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Finds the smallest tuples of values that fail with any other values. The passing rows of the
 * suite exclude most tuples. Each further row is chosen so that about half of the remaining
 * probability is in it, and takes its other values from rows that passed.
 *
 * <p>Related work: FIC (Zhang and Zhang, 2011) and delta debugging bisect one failing row without a
 * weight for its parts; BEN (Ghandehari et al., 2013) ranks suspicious tuples; MixTgTe (Arcaini et
 * al., 2019) alternates generation and isolation.
 */
final class TupleSearch {
  private static final int CONFIRMATIONS = 3;
  private static final double CERTAIN = 0.95;
  private static final int MAX_EXECUTIONS_OF_ROW = 60;
  private static final int MAX_ROUNDS = 200;
  private static final int MAX_COMPARED = 12;

  /** With so many rows that fail now and then, the failures are not reproducible. */
  private static final int MAX_FLAKY = 5;

  private final History history;
  private final Set<Combinations.Row> suite;
  private final List<Tuple> causes = new ArrayList<>();
  private final Map<Tuple, Integer> executionsOf = new HashMap<>();
  private final Set<Combinations.Row> flaky = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Set<Combinations.Row> tried = Collections.newSetFromMap(new IdentityHashMap<>());
  private final @Nullable Set<Integer> targets;
  private final RowChoice rows;
  private final long free;
  private final double rate;
  private int revealed;

  /**
   * A search.
   *
   * @param targets the failing rows of the suite to explain, by index; null for all
   */
  TupleSearch(History history, @Nullable Set<Integer> targets, long seed) {
    this.history = history;
    this.targets = targets;
    int[] levels = history.combinations().levels();
    if (levels.length > Long.SIZE - 2) {
      throw new IllegalArgumentException(
          "at most " + (Long.SIZE - 2) + " inputs can be searched, not " + levels.length);
    }
    long varying = 0;
    for (int i = 0; i < levels.length; i++) {
      varying |= levels[i] > 1 ? 1L << i : 0;
    }
    this.free = varying;
    this.suite = Collections.newSetFromMap(new IdentityHashMap<>());
    this.suite.addAll(history.failing());
    int all = history.failing().size() + history.passing().size();
    this.rate = Math.max(0.02, Math.min(0.9, (double) history.failing().size() / Math.max(1, all)));
    this.rows = new RowChoice(history, causes, new Random(seed));
  }

  /** The found causes. */
  List<Tuple> causes() {
    return List.copyOf(causes);
  }

  /** The executions that were needed to find a cause. */
  int executionsOf(Tuple cause) {
    return executionsOf.getOrDefault(cause, 0);
  }

  /** Adds executions that a cause needed. */
  void needed(Tuple cause, int executions) {
    executionsOf.merge(cause, executions, Integer::sum);
  }

  /** Searches until every failing row that can be explained is explained, or the budget is used. */
  void search() throws InterruptedException {
    for (int round = 0;
        round < MAX_ROUNDS && !history.isExhausted() && history.flakyRows() < MAX_FLAKY;
        round++) {
      causes.removeIf(history::isRefuted);
      Optional<Combinations.Row> row = nextUnexplained();
      if (row.isPresent()) {
        int before = history.executions();
        Optional<Tuple> cause = isolate(row.get());
        if (cause.isPresent()) {
          add(cause.get(), history.executions() - before);
        }
      } else if (targets != null || revealed > causes.size() || !revealMasked()) {
        break;
      }
    }
    removeRefuted();
  }

  /** Removes the causes of which a case passed. */
  void removeRefuted() {
    causes.removeIf(history::isRefuted);
  }

  private void add(Tuple cause, int executions) {
    causes.removeIf(c -> cause.isPartOf(c) && !c.equals(cause));
    causes.add(cause);
    executionsOf.merge(cause, executions, Integer::sum);
  }

  boolean isExplained(int[] row) {
    return history.isExplained(row) || causes.stream().anyMatch(c -> c.isIn(row));
  }

  private List<Combinations.Row> unexplained() {
    return history.failing().stream()
        .filter(f -> !isExplained(f.values()) && !flaky.contains(f))
        .filter(f -> !history.isFlaky(f.values()))
        .toList();
  }

  /** The unexplained row with the most certain candidate. */
  private Optional<Combinations.Row> nextUnexplained() {
    Combinations.Row best = null;
    double bestProbability = -1;
    List<Combinations.Row> open = unexplained();
    List<Combinations.Row> searched = open.stream().filter(this::isSearched).toList();
    for (Combinations.Row row : searched.subList(0, Math.min(searched.size(), MAX_COMPARED))) {
      Candidates candidates = candidates(row, open);
      double probability = candidates.isEmpty() ? 0 : candidates.probability(candidates.best());
      if (probability > bestProbability) {
        best = row;
        bestProbability = probability;
      }
    }
    return Optional.ofNullable(best);
  }

  private boolean isSearched(Combinations.Row row) {
    List<Combinations.Row> executed = history.combinations().executed();
    return !tried.contains(row)
        && (targets == null || targets.stream().anyMatch(i -> executed.get(i) == row));
  }

  private Candidates candidates(Combinations.Row row, List<Combinations.Row> open) {
    return Candidates.of(row, free, history, open, suite, rate);
  }

  private Optional<Tuple> isolate(Combinations.Row failed) throws InterruptedException {
    int began = history.executions();
    boolean repeated = false;
    while (!history.isExhausted() && history.executions() - began < MAX_EXECUTIONS_OF_ROW) {
      Candidates candidates = candidates(failed, unexplained());
      if (candidates.isEmpty()) {
        break;
      }
      int best = candidates.best();
      long mask = candidates.mask(best);
      double probability = candidates.probability(best);
      Tuple tuple = Tuple.of(failed.values(), mask);
      if (!repeated && (Long.bitCount(mask) > 4 || mask == free)) {
        repeated = true;
        if (!history.execute(failed.values()).failed()) {
          flaky.add(failed);
          return Optional.empty();
        }
        continue;
      }
      boolean confirmed = history.confirmations(tuple) >= CONFIRMATIONS;
      if (probability >= CERTAIN && confirmed) {
        return Optional.of(tuple);
      }
      int[] next =
          probability < 0.4 ? rows.split(candidates, free) : confirm(failed, mask, candidates);
      if (next == null && probability < CERTAIN) {
        next = rows.split(candidates, free);
      }
      if (next == null) {
        // No other case can be executed: the remaining candidates are equivalent.
        int missing = CONFIRMATIONS - history.confirmations(tuple);
        for (int i = 0; i < missing && !history.isExhausted(); i++) {
          if (!history.execute(failed.values()).failed()) {
            flaky.add(failed);
            return Optional.empty();
          }
        }
        return Optional.of(tuple);
      }
      history.execute(next);
    }
    if (!repeated && !history.isExhausted() && !history.execute(failed.values()).failed()) {
      flaky.add(failed);
    }
    tried.add(failed);
    return Optional.empty();
  }

  private int @Nullable [] confirm(Combinations.Row failed, long mask, Candidates candidates) {
    int[] row = rows.only(failed.values(), mask, free, true);
    // A row that fails for every candidate says nothing about them.
    return row == null
            || candidates.probabilityWithin(History.agreement(row, failed.values()) & free) > 0.999
                && history.confirmations(Tuple.of(failed.values(), mask)) >= CONFIRMATIONS
        ? null
        : row;
  }

  /**
   * Executes a row with tuples that occur only in failing rows and may hide another cause. The more
   * causes are known, the more of these rows are executed.
   *
   * @return whether there is a row to execute
   */
  private boolean revealMasked() throws InterruptedException {
    revealed++;
    return new MaskedTuples(history, causes, rows, free).execute();
  }

  /** The failing rows of the suite that no cause explains. */
  Set<Integer> unexplainedOfSuite() {
    Set<Integer> indices = new HashSet<>();
    List<Combinations.Row> executed = history.combinations().executed();
    for (int i = 0; i < executed.size(); i++) {
      if (executed.get(i).outcome().failed() && !isExplained(executed.get(i).values())) {
        indices.add(i);
      }
    }
    return indices;
  }

  @Override
  public String toString() {
    return causes + " " + Arrays.toString(history.combinations().levels());
  }
}
