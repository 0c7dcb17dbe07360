package org.sitaf.cli.bisect;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.sitaf.cli.bisect.VersionTests.Tested;
import org.sitaf.cli.compare.Run;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/** A version is bad if one of these cases fails. */
record FailingCases(Map<TestModel, Set<Integer>> cases) implements Criterion {
  boolean isEmpty() {
    return cases.isEmpty();
  }

  /** Without the cases that also fail with another version. */
  FailingCases without(Tested other) {
    Map<TestModel, Set<Integer>> left = new LinkedHashMap<>();
    Map<TestModel, Set<Integer>> failing = other.failing();
    cases.forEach(
        (model, numbers) -> {
          Set<Integer> own = new TreeSet<>(numbers);
          own.removeAll(failing.getOrDefault(model, Set.of()));
          if (!own.isEmpty()) {
            left.put(model, own);
          }
        });
    return new FailingCases(left);
  }

  @Override
  public Decision decide(Tested tested) {
    if (!tested.problem().isEmpty()) {
      return new Decision(Outcome.SKIPPED, tested.problem());
    }
    Decision decision = Decision.GOOD;
    for (Map.Entry<TestModel, Set<Integer>> entry : cases.entrySet()) {
      TestModel model = entry.getKey();
      Run run = tested.runs().get(model);
      if (run == null || tested.unjudged().contains(model.name())) {
        return new Decision(
            Outcome.SKIPPED, "the expected values of " + model.name() + " do not apply");
      }
      for (int no : entry.getValue()) {
        CaseResult result = run.results().get(no);
        if (result != null && Tested.isFailure(result)) {
          return new Decision(Outcome.BAD, "case " + no + ": " + result.message());
        }
        if (result == null || result.verdict() == Verdict.DONT) {
          decision = new Decision(Outcome.SKIPPED, "case " + no + " was not executed");
        }
      }
    }
    return decision;
  }

  @Override
  public String text() {
    return "fails: " + Criterion.numbers(cases);
  }
}
