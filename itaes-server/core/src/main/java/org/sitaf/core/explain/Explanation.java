package org.sitaf.core.explain;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/**
 * The causes of the failures of a result.
 *
 * @param executions number of executed cases beyond the suite
 * @param unexplained numbers of the failed cases without a cause, in ascending order
 */
public record Explanation(List<Cause> causes, int executions, List<Integer> unexplained) {
  public Explanation {
    causes = List.copyOf(causes);
    unexplained = List.copyOf(unexplained);
  }

  /**
   * Explains the failures of a suite of single calls or of sequences.
   *
   * @param results of the cases of the suite; cases that were not executed are ignored
   * @param world of the activity; null if it has none
   * @param cases numbers of the failed cases to explain; null for all
   * @param budget maximum number of further executions
   * @throws InterruptedException if the search is cancelled
   * @throws IllegalStateException if a further case could not be executed
   */
  public static Explanation of(
      TestModel model,
      TestSuite suite,
      List<CaseResult> results,
      @Nullable WorldDescription world,
      @Nullable Set<Integer> cases,
      CaseExecution execution,
      int budget)
      throws InterruptedException {
    return suite.isOfSequences()
        ? new SequenceExplainer(model, suite, results, cases, execution, budget).explain()
        : new Explainer(model, suite, results, world, cases, execution, budget).explain();
  }

  /**
   * A cause.
   *
   * @param parameters the minimal values that fail with any other values, as literals by name;
   *     empty if every case fails, or the cause is a relation
   * @param relation between two parameters, such as {@code A == B}; null if there is none
   * @param verdict of the simplest case
   * @param message of the simplest case
   * @param cases numbers of the failed cases that have this cause
   * @param simplest the simplest failing case: literals by name
   * @param boundary where a numeric parameter begins to fail; null if there is none
   * @param executions number of executed cases beyond the suite for this cause
   * @param steps of the shortest sequence that fails, such as {@code Read(1, 7)}; empty if the
   *     cases are single calls
   */
  public record Cause(
      Map<String, String> parameters,
      @Nullable String relation,
      Verdict verdict,
      String message,
      List<Integer> cases,
      Map<String, String> simplest,
      @Nullable Boundary boundary,
      int executions,
      List<String> steps) {
    /** A cause of the failures of single calls. */
    public Cause(
        Map<String, String> parameters,
        @Nullable String relation,
        Verdict verdict,
        String message,
        List<Integer> cases,
        Map<String, String> simplest,
        @Nullable Boundary boundary,
        int executions) {
      this(
          parameters, relation, verdict, message, cases, simplest, boundary, executions, List.of());
    }

    public Cause {
      parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
      Objects.requireNonNull(verdict);
      Objects.requireNonNull(message);
      cases = List.copyOf(cases);
      simplest = Collections.unmodifiableMap(new LinkedHashMap<>(simplest));
      steps = List.copyOf(steps);
    }
  }

  /** Two neighbouring values of a parameter, of which one passes and the other fails. */
  public record Boundary(String parameter, String passes, String fails) {}
}
