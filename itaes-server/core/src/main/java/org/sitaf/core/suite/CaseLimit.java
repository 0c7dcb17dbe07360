package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.combine.GrownArray;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.combine.ParameterValue;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.TestDataCombinator;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.value.TestValue;

/**
 * Bounds the number of cases: each value at least once, then the rows that cover most tuples,
 * whichever part of the suite they belong to.
 */
final class CaseLimit {
  /** Number of pairs of parameters that a message names. */
  private static final int NAMED_PAIRS = 3;

  private final TestModel model;
  private final int most;
  private final PartProblems problems;
  private final KeptRows kept;
  private final long seed;
  private final Progress progress;
  private Generation.Tuples tuples = new Generation.Tuples(0, 0);

  CaseLimit(
      TestModel model,
      int most,
      PartProblems problems,
      KeptRows kept,
      long seed,
      Progress progress) {
    this.model = model;
    this.most = most;
    this.problems = problems;
    this.kept = kept;
    this.seed = seed;
    this.progress = progress;
  }

  /** The covered and all tuples of the rows. */
  Generation.Tuples tuples() {
    return tuples;
  }

  /**
   * The rows of all cases.
   *
   * @throws InvalidInputException if each value needs more cases
   */
  List<List<TestValue>> rows(List<CasePart> parts, Diagnostics diagnostics) {
    DistinctRows rows = new DistinctRows();
    rows.addAll(kept.rows());
    List<Grown> all = new ArrayList<>();
    for (CasePart part : parts) {
      Interruption.check();
      if (!part.single() || !rows.contains(part.held(), part.heldValue().value())) {
        Grown grown = new Grown(part);
        all.add(grown);
        while (grown.taken < grown.array.needed()) {
          grown.take(rows);
        }
      }
    }
    if (rows.size() > most) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  model.source(),
                  0,
                  "max_cases",
                  String.format(
                      Locale.ROOT,
                      "%d is too small: with each value and each kept case at least once, the"
                          + " smallest number of cases that the generator found is %d",
                      most,
                      rows.size()))));
    }
    while (rows.size() < most) {
      Interruption.check();
      Grown best = null;
      for (Grown grown : all) {
        grown.extend(most - rows.size());
        if (grown.hasNext() && (best == null || grown.nextGain() > best.nextGain())) {
          best = grown;
        }
      }
      if (best == null) {
        break;
      }
      best.take(rows);
    }
    tuples =
        new Generation.Tuples(
            all.stream().mapToLong(Grown::covered).sum(),
            all.stream().mapToLong(Grown::required).sum());
    report(all.get(0), diagnostics);
    return rows.all();
  }

  private void report(Grown combined, Diagnostics diagnostics) {
    if (tuples.covered() == tuples.all()) {
      return;
    }
    List<int[]> rows = List.of(combined.rows).subList(0, combined.taken);
    String pairs =
        new TestDataCombinator()
            .losses(combined.problem, rows).byPair().entrySet().stream()
                .sorted(
                    Comparator.comparing(
                            (Map.Entry<GrownArray.Pair, GrownArray.Loss> e) -> -e.getValue().lost())
                        .thenComparing(e -> e.getKey().first())
                        .thenComparing(e -> e.getKey().second()))
                .limit(NAMED_PAIRS)
                .map(
                    e ->
                        String.format(
                            Locale.ROOT,
                            "%s and %s (%,d of %,d not covered)",
                            model.inputs().get(e.getKey().first()).name(),
                            model.inputs().get(e.getKey().second()).name(),
                            e.getValue().lost(),
                            e.getValue().all()))
                .collect(Collectors.joining(", "));
    diagnostics.warning(
        model.source(),
        0,
        "max_cases",
        String.format(Locale.ROOT, "%,d of %,d tuples are covered", tuples.covered(), tuples.all())
            + (pairs.isEmpty() ? "" : "; most are lost by " + pairs));
  }

  /** The array of a part, of which the first rows are taken. */
  private final class Grown {
    private final CasePart part;
    private final CombinationProblem problem;
    private GrownArray array;
    private int[][] rows;
    private long[] covered;
    private int taken;

    Grown(CasePart part) {
      this.part = part;
      this.problem = problems.problem(part);
      this.array = grow(part.single() ? 1 : most);
      this.rows = array.rows();
      this.covered = array.covered();
      for (int rejected : array.rejectedSeeds()) {
        kept.reportDropped(problem.seeds().get(rejected), part.candidates());
      }
    }

    private GrownArray grow(int limit) {
      return new TestDataCombinator()
          .grow(problem, limit, part.held() < 0, related(), seed, progress);
    }

    /**
     * Values that follow another input. Only few of all tuples hold inputs that are nearly equal,
     * and much code breaks only there.
     */
    private List<ParameterValue> related() {
      List<ParameterValue> all = new ArrayList<>();
      for (int p = 0; p < part.candidates().size(); p++) {
        List<TestValue> values = part.candidates().get(p);
        for (int v = 0; v < values.size() && values.size() > 1; v++) {
          if (values.get(v).relation() != null) {
            all.add(new ParameterValue(p, v));
          }
        }
      }
      return all;
    }

    /**
     * Adds rows if all were taken and tuples are left, because some rows were equal to others. More
     * rows begin with the same ones.
     */
    void extend(int more) {
      if (hasNext() || part.single() || covered() == required()) {
        return;
      }
      array = grow(rows.length + Math.max(more, rows.length));
      rows = array.rows();
      covered = array.covered();
    }

    boolean hasNext() {
      return taken < rows.length;
    }

    long nextGain() {
      return covered[taken] - (taken == 0 ? 0 : covered[taken - 1]);
    }

    void take(DistinctRows into) {
      into.addAll(List.of(problems.row(rows[taken++], part)));
    }

    long covered() {
      return taken == 0 ? 0 : PartProblems.required(part, covered[taken - 1]);
    }

    long required() {
      return rows.length == 0 ? 0 : PartProblems.required(part, array.tuples().covered());
    }
  }
}
