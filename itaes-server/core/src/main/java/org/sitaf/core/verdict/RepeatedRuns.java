package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.TestModel;

/** Several runs of the same cases. Each case has the worst of its results. */
public final class RepeatedRuns {
  private final boolean conditions;
  private final Map<Integer, CaseResult> worst = new LinkedHashMap<>();
  private final List<String> suspicions = new ArrayList<>();
  private @Nullable TestResult last;
  private int runs;

  /** No runs yet. */
  public RepeatedRuns(TestModel model) {
    conditions = !model.postConditions().isEmpty() || !model.trajectoryConditions().isEmpty();
  }

  /** Adds a run. Cases that were not executed do not replace results of earlier runs. */
  public void add(TestResult result) {
    runs++;
    last = result;
    result.suspicions().stream().filter(s -> !suspicions.contains(s)).forEach(suspicions::add);
    for (CaseResult each : result.cases()) {
      worst.merge(each.no(), each, RepeatedRuns::worse);
    }
  }

  private static CaseResult worse(CaseResult earlier, CaseResult later) {
    if (later.verdict() == Verdict.DONT) {
      return earlier;
    }
    return earlier.verdict() == Verdict.DONT
            || earlier.verdict().worse(later.verdict()) != earlier.verdict()
        ? later
        : earlier;
  }

  /** The number of runs. */
  public int count() {
    return runs;
  }

  /**
   * The result of all runs.
   *
   * @throws NullPointerException if there is no run
   */
  public TestResult result() {
    TestResult latest = Objects.requireNonNull(last, "no run");
    if (runs == 1) {
      return latest;
    }
    List<CaseResult> cases = List.copyOf(worst.values());
    return new TestResult(
        latest.name(),
        latest.provenance(),
        Statistics.of(cases, conditions),
        latest.parameters(),
        cases,
        latest.coverage(),
        suspicions);
  }
}
