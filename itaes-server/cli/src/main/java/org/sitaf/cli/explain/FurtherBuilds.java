package org.sitaf.cli.explain;

import java.io.PrintWriter;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.explain.CaseExecution;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;

/** Executes the further cases of an explanation as builds on this machine. */
final class FurtherBuilds implements CaseExecution {
  private static final int REPORT_EVERY = 10;

  private final LocalBuilds builds;
  private final Activity activity;
  private final TestModel model;
  private final TestSuite suite;
  private final PrintWriter progress;
  private int executed;

  /**
   * An execution.
   *
   * @param suite for the parameters of the cases
   */
  FurtherBuilds(
      LocalBuilds builds,
      Activity activity,
      TestModel model,
      TestSuite suite,
      PrintWriter progress) {
    this.builds = builds;
    this.activity = activity;
    this.model = model;
    this.suite = suite;
    this.progress = progress;
  }

  @Override
  public List<CaseResult> execute(List<TestCase> cases) throws InterruptedException {
    TestResult result =
        builds.completed(activity, builds.runQuietly(activity, model, suite.withCases(cases)));
    Map<Integer, CaseResult> byNumber = new HashMap<>();
    result.cases().forEach(c -> byNumber.put(c.no(), c));
    executed += cases.size();
    if (executed % REPORT_EVERY == 0) {
      progress.println(model.name() + ": " + executed + " further cases");
      progress.flush();
    }
    return cases.stream().map(c -> Objects.requireNonNull(byNumber.get(c.no()))).toList();
  }
}
