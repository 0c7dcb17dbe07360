package org.sitaf.cli.falsify;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.falsify.Falsification;
import org.sitaf.core.falsify.Falsification.Outcome;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.GivenCases;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.TrajectoryResult;
import org.sitaf.core.verdict.Verdict;

/** Executes the batches of a search as builds on this machine. */
final class MarginRuns implements Falsification.Executor {
  private final LocalBuilds builds;
  private final Activity activity;
  private final TestModel model;
  private final TestSuite suite;
  private final @Nullable String condition;
  private final PrintWriter progress;
  private final GivenCases cases;
  private int count;
  private double smallest = Double.POSITIVE_INFINITY;

  /**
   * Creates an executor.
   *
   * @param suite for the parameters of the cases
   * @param condition the trajectory condition; null for all of the model
   */
  MarginRuns(
      LocalBuilds builds,
      Activity activity,
      TestModel model,
      TestSuite suite,
      @Nullable String condition,
      PrintWriter progress) {
    this.builds = builds;
    this.activity = activity;
    this.model = model;
    this.suite = suite;
    this.condition = condition;
    this.progress = progress;
    this.cases = new GivenCases(model);
  }

  @Override
  public List<Outcome> execute(List<List<Value>> rows) throws InterruptedException {
    List<TestCase> batch = new ArrayList<>();
    List<Optional<TestCase>> ofRow = new ArrayList<>();
    for (List<Value> row : rows) {
      Optional<TestCase> testCase = cases.of(batch.size() + 1, row);
      testCase.ifPresent(batch::add);
      ofRow.add(testCase);
    }
    Map<Integer, Outcome> outcomes = batch.isEmpty() ? Map.of() : run(batch);
    return ofRow.stream()
        .map(c -> c.map(TestCase::no).map(outcomes::get).orElse(Outcome.NONE))
        .toList();
  }

  private Map<Integer, Outcome> run(List<TestCase> batch) throws InterruptedException {
    TestResult executed =
        builds.completed(activity, builds.runQuietly(activity, model, suite.withCases(batch)));
    Map<Integer, Outcome> outcomes = new HashMap<>();
    for (CaseResult result : executed.cases()) {
      outcomes.put(result.no(), outcome(result));
      smallest = Math.min(smallest, outcomes.get(result.no()).margin());
    }
    count += batch.size();
    progress.printf("%s: %d cases, smallest margin %s%n", model.name(), count, smallest);
    progress.flush();
    return outcomes;
  }

  private Outcome outcome(CaseResult result) {
    Outcome worst = new Outcome(Double.POSITIVE_INFINITY, false, "");
    for (TrajectoryResult trajectory : result.trajectories()) {
      Double margin = trajectory.margin();
      boolean searched = condition == null || condition.equals(trajectory.name());
      if (!searched || margin == null) {
        continue;
      }
      boolean violated = trajectory.verdict() == Verdict.FAIL;
      if (worst.condition().isEmpty()
          || violated && !worst.violated()
          || violated == worst.violated() && margin < worst.margin()) {
        worst = new Outcome(margin, violated, trajectory.name());
      }
    }
    return worst;
  }
}
