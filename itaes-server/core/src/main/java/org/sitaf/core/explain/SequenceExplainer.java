package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.sequence.StepStates;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.FailureGroup;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Explains the failures of sequences: shortens one case of each kind of failure to the steps that
 * it takes. The result is minimal: without any one of its steps, it does not fail in this way, or
 * may not be executed.
 */
public final class SequenceExplainer {
  private final TestSuite suite;
  private final List<CaseResult> results;
  private final @Nullable Set<Integer> targets;
  private final CaseExecution execution;
  private final int budget;
  private final StepStates states;
  private int executions;

  /**
   * An explainer.
   *
   * @param model has a sequence
   * @param results of the cases of the suite
   * @param cases numbers of the failed cases to explain; null for all
   * @param budget maximum number of further executions
   */
  public SequenceExplainer(
      TestModel model,
      TestSuite suite,
      List<CaseResult> results,
      @Nullable Set<Integer> cases,
      CaseExecution execution,
      int budget) {
    this.suite = suite;
    this.results = List.copyOf(results);
    this.targets = cases;
    this.execution = execution;
    this.budget = budget;
    this.states = new StepStates(model, suite.generation().seed());
  }

  /**
   * Searches the shortest sequences.
   *
   * @throws InterruptedException if the search is cancelled
   */
  public Explanation explain() throws InterruptedException {
    Map<String, List<CaseResult>> groups = new LinkedHashMap<>();
    for (CaseResult result : results) {
      boolean failed = result.verdict() == Verdict.FAIL || result.verdict() == Verdict.ERROR;
      if (failed && (targets == null || targets.contains(result.no()))) {
        groups.computeIfAbsent(FailureGroup.kind(result), k -> new ArrayList<>()).add(result);
      }
    }
    List<Cause> causes = new ArrayList<>();
    List<Integer> unexplained = new ArrayList<>();
    for (Map.Entry<String, List<CaseResult>> group : groups.entrySet()) {
      List<Integer> numbers = group.getValue().stream().map(CaseResult::no).toList();
      int before = executions;
      Optional<Failure> shortest = shortest(group.getKey(), group.getValue());
      if (shortest.isPresent()) {
        causes.add(cause(shortest.get(), numbers, executions - before));
      } else {
        unexplained.addAll(numbers);
      }
    }
    unexplained.sort(null);
    return new Explanation(causes, executions, unexplained);
  }

  /** A case that fails, and its result. */
  private record Failure(TestCase testCase, CaseResult result) {
    /** The number of steps up to the one that decides; all if none does. */
    int length() {
      List<StepResult> steps = result.steps();
      for (int i = 0; i < steps.size(); i++) {
        if (steps.get(i).decides()) {
          return i + 1;
        }
      }
      return steps.size();
    }

    List<TestStep> needed() {
      return testCase.steps().subList(0, length());
    }
  }

  private Cause cause(Failure failure, List<Integer> numbers, int needed) {
    Map<String, String> initial = new LinkedHashMap<>();
    for (int i = 0; i < suite.parameters().size(); i++) {
      initial.put(suite.parameters().get(i).name(), failure.testCase().values().get(i));
    }
    return new Cause(
        Map.of(),
        null,
        failure.result().verdict(),
        failure.result().message(),
        numbers,
        initial,
        null,
        needed,
        failure.needed().stream()
            .map(step -> step.name() + "(" + String.join(", ", step.values()) + ")")
            .toList());
  }

  /** The minimal failure of a kind; empty if it cannot be reproduced within the budget. */
  private Optional<Failure> shortest(String kind, List<CaseResult> failed)
      throws InterruptedException {
    Map<Integer, TestCase> byNumber = new HashMap<>();
    suite.cases().forEach(c -> byNumber.put(c.no(), c));
    Failure first =
        failed.stream()
            .map(r -> new Failure(Objects.requireNonNull(byNumber.get(r.no())), r))
            .min(Comparator.comparingInt(Failure::length))
            .orElseThrow();
    // Without the steps after the failure; this also shows whether it is reproducible.
    Optional<Failure> current = failing(kind, first, List.of(first.needed()));
    boolean shorter = current.isPresent();
    while (shorter) {
      Failure longer = current.orElseThrow();
      Optional<Failure> found = failing(kind, longer, without(longer.needed()));
      shorter = found.isPresent();
      current = shorter ? found : current;
    }
    return current;
  }

  /** The sequences without one step, later steps first: they have fewer consequences. */
  private static List<List<TestStep>> without(List<TestStep> steps) {
    List<List<TestStep>> shorter = new ArrayList<>();
    for (int i = steps.size() - 1; i >= 0; i--) {
      List<TestStep> rest = new ArrayList<>(steps);
      rest.remove(i);
      if (!rest.isEmpty()) {
        shorter.add(rest);
      }
    }
    return shorter;
  }

  /** Executes sequences; the one that fails in this way with the fewest steps. */
  private Optional<Failure> failing(String kind, Failure like, List<List<TestStep>> sequences)
      throws InterruptedException {
    List<TestCase> cases = new ArrayList<>();
    for (List<TestStep> sequence : sequences) {
      Optional<List<TestStep>> steps = states.replanned(sequence);
      if (steps.isPresent() && executions + cases.size() < budget) {
        boolean valid = like.testCase().valid() || steps.get().stream().allMatch(TestStep::valid);
        cases.add(
            new TestCase(
                cases.size() + 1, valid, like.testCase().values(), List.of(), steps.get()));
      }
    }
    if (cases.isEmpty()) {
      return Optional.empty();
    }
    List<CaseResult> ended = execution.execute(cases);
    executions += cases.size();
    List<Failure> same = new ArrayList<>();
    for (int i = 0; i < cases.size(); i++) {
      CaseResult result = ended.get(i);
      if (result.verdict() != Verdict.PASS && FailureGroup.kind(result).equals(kind)) {
        same.add(new Failure(cases.get(i), result));
      }
    }
    return same.stream().min(Comparator.comparingInt(Failure::length));
  }
}
