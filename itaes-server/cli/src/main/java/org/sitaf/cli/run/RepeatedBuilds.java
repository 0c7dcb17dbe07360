package org.sitaf.cli.run;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.RepeatedRuns;
import org.sitaf.core.verdict.TestResult;

/** Executes the cases of a suite as often as the options say. */
public record RepeatedBuilds(LocalBuilds builds, CaseOptions options, PrintWriter err) {
  private static final int MAX_DIFFERING = 20;

  /**
   * How the builds ended.
   *
   * @param last the outcome of the last build
   * @param runs the results, also of a build that was cancelled while its cases ran
   * @param warnings of the compiler
   */
  record Ended(BuildOutcome last, RepeatedRuns runs, List<String> warnings) {
    Optional<TestResult> result() {
      return runs.count() == 0 ? Optional.empty() : Optional.of(runs.result());
    }
  }

  Ended run(Activity activity, TestModel model, TestSuite suite) {
    RepeatedRuns runs = new RepeatedRuns(model);
    List<String> warnings = List.of();
    for (int run = 1; ; run++) {
      if (options.runs() > 1) {
        err.println(
            model.name()
                + ": run "
                + run
                + (options.repeat == null ? "" : " of " + options.runs()));
        err.flush();
      }
      BuildOutcome outcome = builds.run(activity, model, suite);
      Optional<TestResult> result = builds.finishedOfCancelled();
      if (outcome instanceof BuildOutcome.Completed completed) {
        result = Optional.of(completed.result());
        warnings = completed.warnings();
      }
      result.ifPresent(runs::add);
      boolean failed = result.isPresent() && !result.get().allPassed();
      if (!(outcome instanceof BuildOutcome.Completed)
          || run == options.runs()
          || failed && options.untilFailure) {
        return new Ended(outcome, runs, warnings);
      }
    }
  }

  /** Prints the cases whose verdicts differ between the runs. */
  static void print(RepeatedRuns runs, PrintWriter out) {
    if (runs.count() < 2) {
      return;
    }
    List<String> differing = runs.differing();
    if (differing.isEmpty()) {
      out.println("in " + runs.count() + " runs each case had the same verdict");
    } else {
      out.println("verdicts differ between " + runs.count() + " runs:");
      differing.stream().limit(MAX_DIFFERING).forEach(line -> out.println("  " + line));
      if (differing.size() > MAX_DIFFERING) {
        out.println("  and " + (differing.size() - MAX_DIFFERING) + " more cases");
      }
    }
    out.flush();
  }
}
