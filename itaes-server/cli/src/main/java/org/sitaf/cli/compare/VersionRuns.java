package org.sitaf.cli.compare;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.spool.Folders;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;

/** Runs the cases of one model with one version, each time in new processes. */
public final class VersionRuns {
  private final LocalBuilds builds;
  private final Version version;
  private final TestModel model;
  private int count;

  public VersionRuns(LocalBuilds builds, Version version, TestModel model) {
    this.builds = builds;
    this.version = version;
    this.model = model;
  }

  /** Runs cases, with repeated calls if the activity or the model orders them. */
  Run timed(TestSuite suite, int variation) throws IOException, InterruptedException {
    return run(version.activity(), model, suite, variation, false);
  }

  /** Runs cases without repeated calls. */
  public Run once(TestSuite suite, int variation) throws IOException, InterruptedException {
    return run(version.activity().withoutTiming(), model.withoutTiming(), suite, variation, false);
  }

  /** Runs cases without repeated calls and measures the coverage of the component. */
  Run covered(TestSuite suite, int variation) throws IOException, InterruptedException {
    return run(version.activity().withoutTiming(), model.withoutTiming(), suite, variation, true);
  }

  /** The files of the version. */
  FileTree files() {
    return version.activity().files();
  }

  /** Whether the sources of the component are part of the activity. */
  boolean hasSources() {
    return version.activity().profile().component().sources() != null;
  }

  /** Deletes the signals of a run. */
  public static void delete(Run run) throws IOException {
    Folders.delete(run.signals().folder());
  }

  private Run run(
      Activity activity, TestModel tested, TestSuite suite, int variation, boolean coverage)
      throws IOException, InterruptedException {
    SignalFiles signals =
        new SignalFiles(
            builds.folder("signals/%s-%s-%d".formatted(version.label(), tested.name(), ++count)));
    Map<Integer, CaseRecord> records = new ConcurrentHashMap<>();
    BuildOutcome outcome;
    try {
      outcome =
          builds.observe(
              activity,
              tested,
              suite,
              variation,
              coverage,
              new LocalBuilds.CaseObserver() {
                @Override
                public void signals(int no, Trace trace) {
                  signals.write(no, trace);
                }

                @Override
                public void caseRecorded(CaseRecord record) {
                  records.put(record.no(), record);
                }

                @Override
                public void caseFinished(CaseResult result) {
                  // The outcome holds all results.
                }
              });
    } catch (InvalidInputException e) {
      return new Run(null, Map.of(), Map.of(), signals, String.valueOf(e.getMessage()));
    }
    if (outcome instanceof BuildOutcome.Cancelled) {
      throw new InterruptedException("the comparison was cancelled");
    }
    if (outcome instanceof BuildOutcome.Completed completed) {
      return new Run(
          completed.result(),
          records,
          completed.result().cases().stream()
              .collect(Collectors.toMap(CaseResult::no, Function.identity())),
          signals,
          "");
    }
    return new Run(null, Map.of(), Map.of(), signals, problem(outcome));
  }

  private static String problem(BuildOutcome outcome) {
    if (outcome instanceof BuildOutcome.CompilationFailed failed) {
      String first =
          failed.diagnostics().isEmpty() ? "" : ": " + failed.diagnostics().get(0).toString();
      return failed.message() + first;
    }
    return outcome instanceof BuildOutcome.InfrastructureFailed failed
        ? failed.message()
        : outcome.toString();
  }
}
