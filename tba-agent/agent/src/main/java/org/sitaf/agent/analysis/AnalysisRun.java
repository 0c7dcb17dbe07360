package org.sitaf.agent.analysis;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Predicate;
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
import org.sitaf.agent.build.QuietBuild;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.explain.report.Bundle;
import org.sitaf.core.explain.report.RunRecord;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
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
  private static final int MAX_MUTATIONS = 50;
  private static final Duration MUTATIONS_LIMIT = Duration.ofMinutes(10);

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
      listener.stage(BuildStage.RUNNING);
      return new BuildOutcome.Analysed(reportOf(log));
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

  private AnalysisReport reportOf(BuildLog log) throws InterruptedException {
    if (order instanceof AnalysisOrder.Explain explain) {
      return explain(explain.analysed(), log);
    }
    return order instanceof AnalysisOrder.Repeat repeat
        ? repeat(repeat.analysed(), log)
        : score(log);
  }

  private AnalysisReport repeat(TestResult analysed, BuildLog log) throws InterruptedException {
    TestSuite suite = application.suite();
    return new RepeatedCases(
            (variation, signals) ->
                execute(
                    model,
                    suite,
                    settings.varied(variation).withSignals(),
                    new QuietBuild() {
                      @Override
                      public void signals(int no, Trace trace) {
                        signals.accept(no, trace);
                      }

                      @Override
                      public void caseFinished(CaseResult result) {
                        report(result);
                      }
                    }),
            log::remark)
        .run(analysed, order.maxCases() / suite.cases().size(), activity.limits().caseWall());
  }

  private Scored score(BuildLog log) throws InterruptedException {
    log.remark("executing the cases of the suite and further ones");
    TestModel single = model.withoutRelations();
    SpecificationScore score =
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
            .score(order.maxCases());
    if (MutatedModel.count(activity) == 0) {
      return new Scored(score, null);
    }
    log.remark("testing mutations of the sources");
    Duration left = Duration.ofNanos(end - System.nanoTime()).dividedBy(2);
    Duration limit = left.compareTo(MUTATIONS_LIMIT) < 0 ? left : MUTATIONS_LIMIT;
    return new Scored(
        score,
        new MutatedModel(activity, application.suite(), this::executeMutated)
            .score(MAX_MUTATIONS, limit, done -> {}));
  }

  private BuildOutcome executeMutated(Activity changed, Predicate<CaseResult> ends)
      throws InterruptedException {
    AtomicReference<BuildRun> run = new AtomicReference<>();
    return outcomeOf(
        InterfaceTestApplicationGenerator.generate(changed, model, application.suite()),
        settings,
        new QuietBuild() {
          @Override
          public void caseFinished(CaseResult result) {
            BuildRun started = run.get();
            if (ends.test(result) && started != null) {
              started.cancel("the mutation is noticed");
            }
          }
        },
        run::set);
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
    return new Explained(explanation, records, further, ExplainedInputs.of(model, suite));
  }

  private List<CaseResult> executed(TestSuite suite, BuildLog log) throws InterruptedException {
    TestResult result = execute(model, suite, settings, new QuietBuild());
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
        : RunRecord.of(execute(model, only.get(), settings, new QuietBuild())).entries();
  }

  private TestResult execute(
      TestModel executed, TestSuite suite, BuildSettings with, BuildListener observer)
      throws InterruptedException {
    BuildOutcome outcome =
        outcomeOf(
            InterfaceTestApplicationGenerator.generate(activity, executed, suite),
            with,
            observer,
            run -> {});
    if (outcome instanceof BuildOutcome.Cancelled cancelled) {
      throw new InterruptedException(cancelled.reason());
    }
    if (!(outcome instanceof BuildOutcome.Completed completed)) {
      throw new BuildFailedException(outcome);
    }
    return completed.result();
  }

  private BuildOutcome outcomeOf(
      TestApplication built, BuildSettings with, BuildListener observer, Consumer<BuildRun> started)
      throws InterruptedException {
    Duration left = Duration.ofNanos(end - System.nanoTime());
    if (left.isNegative() || left.isZero()) {
      throw new InterruptedException(
          "the analysis took longer than " + LIMIT.toMinutes() + " minutes");
    }
    Path folder = directory.resolve("build-" + ++builds);
    BuildRun run = new BuildRun(built, folder, with.within(left), observer);
    started.accept(run);
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
    return outcome;
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
    return new QuietBuild() {
      @Override
      public void caseRecorded(org.sitaf.core.verdict.CaseRecord record) {
        observer.caseRecorded(record);
      }

      @Override
      public void signals(int no, Trace trace) {
        observer.signals(no, trace);
      }

      @Override
      public void caseFinished(CaseResult result) {
        listener.caseFinished(result);
      }
    };
  }
}
