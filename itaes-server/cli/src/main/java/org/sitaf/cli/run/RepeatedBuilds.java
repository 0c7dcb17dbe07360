package org.sitaf.cli.run;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.flaky.FlakyCase;
import org.sitaf.core.flaky.FlakyCases;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.RepeatedRuns;
import org.sitaf.core.verdict.TestResult;

/** Executes the cases of a suite as often as the options say. */
public record RepeatedBuilds(LocalBuilds builds, CaseOptions options, PrintWriter err) {
  private static final int MAX_DIFFERING = 20;
  private static final double MILLIS_PER_SECOND = 1e3;

  /**
   * How the builds ended.
   *
   * @param last the outcome of the last build
   * @param runs the results, also of a build that was cancelled while its cases ran
   * @param flaky the cases whose verdicts or values differ between the runs
   * @param warnings of the compiler
   */
  record Ended(BuildOutcome last, RepeatedRuns runs, List<FlakyCase> flaky, List<String> warnings) {
    Optional<TestResult> result() {
      return runs.count() == 0 ? Optional.empty() : Optional.of(runs.result());
    }
  }

  Ended run(Activity activity, TestModel model, TestSuite suite) {
    RepeatedRuns runs = new RepeatedRuns(model);
    FlakyCases flaky = new FlakyCases(activity.limits().caseWall().toMillis() / MILLIS_PER_SECOND);
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
      // Each run has other hashes and other contents of fresh memory, which unstable code shows.
      BuildOutcome outcome =
          options.runs() == 1
              ? builds.run(activity, model, suite)
              : builds.run(activity, model, suite, run - 1, flaky::signals);
      Optional<TestResult> result = builds.finishedOfCancelled();
      if (outcome instanceof BuildOutcome.Completed completed) {
        result = Optional.of(completed.result());
        warnings = completed.warnings();
      }
      result.ifPresent(runs::add);
      result.ifPresent(flaky::add);
      boolean failed = result.isPresent() && !result.get().allPassed();
      if (!(outcome instanceof BuildOutcome.Completed)
          || run == options.runs()
          || failed && options.untilFailure) {
        return new Ended(outcome, runs, flaky.find(), warnings);
      }
    }
  }

  /** Prints the cases whose verdicts or values differ between the runs, and why. */
  static void print(int runs, List<FlakyCase> flaky, PrintWriter out) {
    if (runs < 2) {
      return;
    }
    if (flaky.isEmpty()) {
      out.println("in " + runs + " runs each case had the same verdict and the same values");
    } else {
      out.println("not reproducible in " + runs + " runs:");
      flaky.stream()
          .limit(MAX_DIFFERING)
          .forEach(f -> out.println("  " + Printable.line(f.line())));
      if (flaky.size() > MAX_DIFFERING) {
        out.println("  and " + (flaky.size() - MAX_DIFFERING) + " more cases");
      }
    }
    out.flush();
  }
}
