package org.sitaf.agent.analysis;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.AnalysisReport;
import org.sitaf.agent.build.AnalysisReport.Explained;
import org.sitaf.agent.build.AnalysisReport.Scored;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildLog;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.description.DataType;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.explain.report.Bundle;
import org.sitaf.core.explain.report.RunRecord;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Analyses a test application with further cases. Each of them is a build of its own, with the
 * sandbox and the limits of a build; all together have a time limit.
 */
public final class AnalysisRun {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration LIMIT = Duration.ofHours(1);
  private static final int MAX_FURTHER_SHOWN = 1_000;
  private static final int MAX_VALUES_SHOWN = 100;

  private final TestApplication application;
  private final Activity activity;
  private final TestModel model;
  private final AnalysisOrder order;
  private final Path directory;
  private final BuildSettings settings;
  private final BuildListener listener;
  private final List<AnalysisReport.Further> further = new ArrayList<>();
  private final long end;

  private int builds;
  private int cases;
  private @Nullable BuildRun current;
  private @Nullable Thread worker;
  private @Nullable String stopReason;

  /**
   * Creates an analysis.
   *
   * @param directory for the files, such as {@link BuildRun#LOG}; deleted by the caller
   * @param listener gets stages, the log, and each further case with a number from 1
   */
  public AnalysisRun(
      TestApplication application,
      AnalysisOrder order,
      Path directory,
      BuildSettings settings,
      BuildListener listener) {
    this.application = application;
    this.activity = application.activity().withoutTiming();
    this.model = application.model().withoutTiming();
    this.order = order;
    this.directory = directory.toAbsolutePath().normalize();
    this.settings = settings.withCoverage(false);
    this.listener = listener;
    Duration limit = settings.atMost().compareTo(LIMIT) < 0 ? settings.atMost() : LIMIT;
    this.end = System.nanoTime() + limit.toNanos();
  }

  /** A build of the analysis failed. */
  private static final class BuildFailedException extends RuntimeException {
    private static final long serialVersionUID = 1L;
    private final transient BuildOutcome outcome;

    BuildFailedException(BuildOutcome outcome) {
      super("a build of the analysis failed");
      this.outcome = outcome;
    }
  }

  /** Cancels the analysis; may be called from any thread, also before the start. */
  public void cancel(String reason) {
    BuildRun running;
    synchronized (this) {
      if (stopReason == null) {
        stopReason = reason;
      }
      running = current;
      if (worker != null) {
        worker.interrupt();
      }
    }
    if (running != null) {
      running.cancel(reason);
    }
  }

  /** Runs the analysis and returns its outcome; never throws. */
  public BuildOutcome run() {
    synchronized (this) {
      worker = Thread.currentThread();
    }
    try {
      Files.createDirectories(directory);
      try (BuildLog log = new BuildLog(directory.resolve(BuildRun.LOG), listener)) {
        BuildOutcome outcome = analyse(log);
        if (outcome instanceof BuildOutcome.InfrastructureFailed failed) {
          log.remark(failed.message());
        } else if (outcome instanceof BuildOutcome.Cancelled cancelled) {
          log.remark("cancelled: " + cancelled.reason());
        }
        return outcome;
      }
    } catch (IOException e) {
      return new BuildOutcome.InfrastructureFailed(
          "the folder of the analysis cannot be used: " + e);
    } finally {
      synchronized (this) {
        worker = null;
        if (stopReason != null) {
          // The interrupt was ours.
          Thread.interrupted();
        }
      }
    }
  }

  private BuildOutcome analyse(BuildLog log) {
    try {
      listener.stage(BuildStage.PREPARING);
      log.remark(settings.sandbox().description());
      TestResult analysed = order.analysed();
      listener.stage(BuildStage.RUNNING);
      return new BuildOutcome.Analysed(analysed == null ? score(log) : explain(analysed, log));
    } catch (InterruptedException | CancellationException e) {
      // A cancelled search throws its own exception.
      synchronized (this) {
        return new BuildOutcome.Cancelled(
            stopReason == null ? String.valueOf(e.getMessage()) : stopReason);
      }
    } catch (BuildFailedException e) {
      return e.outcome;
    } catch (InvalidInputException e) {
      return new BuildOutcome.CompilationFailed(
          "the test application cannot be analysed",
          e.diagnostics().stream()
              .map(d -> new SourceDiagnostic(d.file(), d.line(), 0, d.message(), false))
              .toList());
    } catch (IllegalStateException | UncheckedIOException e) {
      return new BuildOutcome.InfrastructureFailed(String.valueOf(e.getMessage()));
    } catch (RuntimeException e) {
      LOGGER.log(System.Logger.Level.ERROR, "internal error in an analysis", e);
      return new BuildOutcome.InfrastructureFailed("internal error: " + e);
    }
  }

  private Scored score(BuildLog log) throws InterruptedException {
    log.remark("executing the cases of the suite and further ones");
    TestModel single = model.withoutRelations();
    return new Scored(
        new ScoredModel(
                activity,
                single,
                application.suite(),
                (suite, signals, observer) ->
                    execute(
                        single,
                        suite,
                        signals ? settings.withSignals() : settings,
                        forwarding(observer)))
            .score(order.maxCases()));
  }

  private Explained explain(TestResult analysed, BuildLog log) throws InterruptedException {
    TestSuite suite = application.suite();
    Explanation explanation =
        Explanation.of(
            model,
            suite,
            analysed.cases(),
            activity.world(),
            null,
            further -> executed(suite.withCases(further), log),
            order.maxCases());
    List<Map<String, String>> records = new ArrayList<>();
    for (Cause cause : explanation.causes()) {
      records.add(record(suite, cause));
    }
    return new Explained(explanation, records, further, inputs(suite));
  }

  private List<CaseResult> executed(TestSuite suite, BuildLog log) throws InterruptedException {
    TestResult result = execute(model, suite, settings, new Quiet());
    Map<Integer, CaseResult> byNumber = new HashMap<>();
    result.cases().forEach(c -> byNumber.put(c.no(), c));
    List<CaseResult> ended = new ArrayList<>();
    for (TestCase each : suite.cases()) {
      CaseResult found = byNumber.get(each.no());
      if (found == null) {
        throw new IllegalStateException("a further case has no result");
      }
      ended.add(found);
      boolean failed = found.verdict() == Verdict.FAIL || found.verdict() == Verdict.ERROR;
      if (further.size() < MAX_FURTHER_SHOWN) {
        further.add(new AnalysisReport.Further(found.values(), failed));
      }
      report(found);
      log.remark(
          "case " + cases + ": " + String.join(", ", found.values()) + ": " + found.verdict());
    }
    return ended;
  }

  /** Reports a case under the number of the further cases. */
  private void report(CaseResult ended) {
    listener.caseFinished(
        new CaseResult(
            ++cases,
            ended.verdict(),
            ended.values(),
            ended.expected(),
            ended.actual(),
            ended.time(),
            ended.message()));
  }

  private Map<String, String> record(TestSuite suite, Cause cause) throws InterruptedException {
    Optional<TestSuite> only = Bundle.simplest(model, suite, cause, 1);
    return only.isEmpty()
        ? Map.of()
        : RunRecord.of(execute(model, only.get(), settings, new Quiet())).entries();
  }

  private List<AnalysisReport.Input> inputs(TestSuite suite) {
    InputValidity validity = new InputValidity(model, suite.generation().seed());
    List<AnalysisReport.Input> inputs = new ArrayList<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      Map<String, Boolean> values = new LinkedHashMap<>();
      for (TestCase each : suite.cases()) {
        String literal = each.values().get(i);
        if (values.size() < MAX_VALUES_SHOWN && !values.containsKey(literal)) {
          values.put(literal, validity.isValid(i, literal));
        }
      }
      boolean numeric = input.type() instanceof DataType.Scalar scalar && scalar.type().isNumeric();
      inputs.add(new AnalysisReport.Input(input.name(), numeric, values));
    }
    return inputs;
  }

  private TestResult execute(
      TestModel executed, TestSuite suite, BuildSettings with, BuildListener observer)
      throws InterruptedException {
    Duration left = Duration.ofNanos(end - System.nanoTime());
    if (left.isNegative() || left.isZero()) {
      throw new InterruptedException(
          "the analysis took longer than " + LIMIT.toMinutes() + " minutes");
    }
    Path folder = directory.resolve("build-" + ++builds);
    BuildRun run =
        new BuildRun(
            InterfaceTestApplicationGenerator.generate(activity, executed, suite),
            folder,
            with.within(left),
            observer);
    synchronized (this) {
      if (stopReason != null) {
        throw new InterruptedException(stopReason);
      }
      current = run;
    }
    BuildOutcome outcome = run.run();
    synchronized (this) {
      current = null;
    }
    delete(folder);
    if (outcome instanceof BuildOutcome.Cancelled cancelled) {
      throw new InterruptedException(cancelled.reason());
    }
    if (!(outcome instanceof BuildOutcome.Completed completed)) {
      throw new BuildFailedException(outcome);
    }
    return completed.result();
  }

  private static void delete(Path folder) {
    try {
      Folders.delete(folder);
    } catch (IOException e) {
      throw new UncheckedIOException("cannot delete " + folder, e);
    }
  }

  /** Hands over the records, and reports each case. */
  private BuildListener forwarding(BuildListener observer) {
    return new Quiet() {
      @Override
      public void caseRecorded(org.sitaf.core.verdict.CaseRecord record) {
        observer.caseRecorded(record);
      }

      @Override
      public void signals(int no, org.sitaf.core.trajectory.Trace trace) {
        observer.signals(no, trace);
      }

      @Override
      public void caseFinished(CaseResult result) {
        listener.caseFinished(result);
      }
    };
  }

  /** The builds of an analysis have no log of their own. */
  private static class Quiet implements BuildListener {
    @Override
    public void stage(BuildStage stage) {
      // The analysis has its own stages.
    }

    @Override
    public void log(byte[] utf8) {
      // The component's output of further cases is not kept.
    }

    @Override
    public void caseFinished(CaseResult result) {
      // The analysis reports its cases.
    }

    @Override
    public void recorded(int no, Path recording) {
      // Nothing is recorded.
    }
  }
}
