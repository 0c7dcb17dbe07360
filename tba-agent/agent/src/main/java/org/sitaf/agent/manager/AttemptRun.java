package org.sitaf.agent.manager;

import io.grpc.Context;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.analysis.AnalysisRun;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.build.RecordingOrder.Cases;
import org.sitaf.agent.build.SignalExcerpt;
import org.sitaf.agent.build.SignalLimits;
import org.sitaf.agent.spool.FileCache;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.v1.ApplicationFile;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.RecordingOrder;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.CaseResult;

/** Runs one attempt: downloads the test application and builds it. */
final class AttemptRun {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final long MAX_APPLICATION_BYTES = 512L << 20;
  private static final int MAX_RECORDINGS = 100_000;
  private static final int MAX_DAMAGED_DOWNLOADS = 3;
  private static final long SUSPEND_GRACE_MS = 2000;

  /** The file of an assignment with the result that is analysed. */
  private static final String ANALYSED = "analysed-result.xml";

  private final Attempt attempt;
  private final Assignment assignment;
  private final Path directory;
  private final BuildSettings settings;
  private final ServerCalls calls;
  private final FileCache cache;

  private final Context.CancellableContext downloadContext = Context.ROOT.withCancellation();
  private final CountDownLatch stop = new CountDownLatch(1);
  private @Nullable String stopReason;
  private boolean stoppedByAgent;
  private boolean abandoned;
  private int casesLeft = Integer.MAX_VALUE;

  /** Cancels what runs; null before it runs. */
  private @Nullable Consumer<String> running;

  AttemptRun(
      Attempt attempt,
      Assignment assignment,
      Path directory,
      BuildSettings settings,
      ServerCalls calls,
      FileCache cache) {
    this.attempt = attempt;
    this.assignment = assignment;
    this.directory = directory;
    this.settings = settings;
    this.calls = calls;
    this.cache = cache;
  }

  Attempt attempt() {
    return attempt;
  }

  /** Whether the build uses real devices. */
  boolean usesDevices() {
    return assignment.getDevicesCount() > 0;
  }

  /** Folder of recordings and signals that were not uploaded yet; may not exist. */
  Path recordings() {
    return directory.resolve("recordings");
  }

  /** Cancels the build for a user. */
  void cancel(String reason) {
    stop(reason);
  }

  /** Stops because the agent ends; the server assigns the build again. */
  void stopForAgent() {
    synchronized (this) {
      stoppedByAgent = stopReason == null;
    }
    stop("the agent was stopped");
  }

  /**
   * The server no longer accepts this attempt: stop, unless all cases have ended, because the
   * server stores late results.
   */
  void abandon() {
    synchronized (this) {
      if (abandoned) {
        return;
      }
      abandoned = true;
    }
    Thread later = new Thread(this::stopUnlessAllCasesEnded, "sitaf-give-up");
    later.setDaemon(true);
    later.start();
  }

  /** Waits a moment for the progress of the test application after the agent was suspended. */
  private void stopUnlessAllCasesEnded() {
    try {
      Thread.sleep(SUSPEND_GRACE_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    synchronized (this) {
      if (casesLeft == 0) {
        return;
      }
    }
    stop("the attempt has ended");
  }

  private void stop(String reason) {
    Consumer<String> cancel;
    synchronized (this) {
      if (stopReason == null) {
        stopReason = reason;
      }
      cancel = running;
    }
    stop.countDown();
    downloadContext.cancel(null);
    if (cancel != null) {
      cancel.accept(reason);
    }
  }

  /** Runs the attempt; empty if nothing has to be submitted. */
  Optional<BuildOutcome> run() {
    BuildOutcome outcome;
    try (RecordingUpload recordings = new RecordingUpload(attempt, calls);
        ProgressReport report =
            new ProgressReport(attempt, calls, directory, recordings, this::abandon)) {
      report.stage(BuildStage.PREPARING);
      outcome = downloadAndBuild(report);
    }
    synchronized (this) {
      if (abandoned && !(outcome instanceof BuildOutcome.Completed)) {
        return Optional.empty();
      }
      return Optional.of(
          stoppedByAgent && outcome instanceof BuildOutcome.Cancelled cancelled
              ? new BuildOutcome.InfrastructureFailed(cancelled.reason())
              : outcome);
    }
  }

  private BuildSettings recorded() {
    RecordingOrder order = assignment.getRecordings();
    int cases = atMost(assignment.getSignals().getMaxCases());
    long bytes = Math.max(0, assignment.getSignals().getMaxBytes());
    BuildSettings keeping =
        cases == 0 ? settings : settings.keeping(new SignalLimits(cases, bytes));
    return switch (order.getCases()) {
      case FAILED -> keeping.recording(recorded(order, Cases.FAILED));
      case ALL -> keeping.recording(recorded(order, Cases.ALL));
      case CASES_UNSPECIFIED, UNRECOGNIZED -> keeping;
    };
  }

  private org.sitaf.agent.build.RecordingOrder recorded(RecordingOrder order, Cases cases) {
    return new org.sitaf.agent.build.RecordingOrder(
        recordings(), cases, atMost(order.getMaxRecordings()), Math.max(0, order.getMaxBytes()));
  }

  private static int atMost(int unsigned) {
    return (int) Math.min(Integer.toUnsignedLong(unsigned), MAX_RECORDINGS);
  }

  private BuildOutcome downloadAndBuild(ProgressReport report) {
    try {
      FileTree files = download();
      TestApplication application = TestApplication.read(files);
      Supplier<BuildOutcome> work =
          assignment.hasAnalysis()
              ? analysis(application, files, report)
              : build(application, report);
      synchronized (this) {
        if (stopReason != null) {
          return new BuildOutcome.Cancelled(stopReason);
        }
      }
      try {
        return work.get();
      } finally {
        startCompilerAhead(application);
      }
    } catch (InvalidInputException e) {
      return new BuildOutcome.CompilationFailed(
          "the test application is not valid",
          e.diagnostics().stream()
              .map(d -> new SourceDiagnostic(d.file(), d.line(), 0, d.message(), false))
              .toList());
    } catch (StoppedException e) {
      synchronized (this) {
        return new BuildOutcome.Cancelled(String.valueOf(stopReason));
      }
    } catch (IOException | UncheckedIOException | IllegalArgumentException e) {
      return new BuildOutcome.InfrastructureFailed(
          "the test application cannot be downloaded: " + e.getMessage());
    }
  }

  /** Starts the compiler for the next build of this language, unless it is running. */
  private void startCompilerAhead(TestApplication application) {
    settings
        .toolchains()
        .startAhead(application.activity().profile().harness(), settings.sandbox());
  }

  private Supplier<BuildOutcome> build(TestApplication application, ProgressReport report) {
    BuildRun run = new BuildRun(application, directory, recorded(), counting(report, application));
    synchronized (this) {
      running = run::cancel;
      casesLeft = application.suite().cases().size();
    }
    return run::run;
  }

  private Supplier<BuildOutcome> analysis(
      TestApplication application, FileTree files, ProgressReport report) {
    AnalysisRun run =
        new AnalysisRun(
            application,
            AnalysisMessages.order(assignment.getAnalysis(), files.content(ANALYSED).orElse(null)),
            directory,
            settings,
            counting(report, application));
    synchronized (this) {
      running = run::cancel;
    }
    return run::run;
  }

  /** Forwards events to the report and counts the remaining cases. */
  private BuildListener counting(ProgressReport report, TestApplication application) {
    return new BuildListener() {
      private boolean compilerStarted;

      @Override
      public void stage(BuildStage stage) {
        report.stage(stage);
      }

      @Override
      public void log(byte[] utf8) {
        report.log(utf8);
      }

      @Override
      public void caseFinished(CaseResult result) {
        synchronized (AttemptRun.this) {
          casesLeft--;
        }
        report.caseFinished(result);
        // Not before the first case, which it would delay. A process that is not idle would take
        // time from the others.
        if (!compilerStarted && settings.sandbox().canIdle()) {
          compilerStarted = true;
          startCompilerAhead(application);
        }
      }

      @Override
      public void recorded(int no, Path recording) {
        report.recorded(no, recording);
      }

      @Override
      public void secondRunRecorded(int no, int relation, Path recording) {
        report.secondRunRecorded(no, relation, recording);
      }

      @Override
      public void signalsKept(int no, SignalExcerpt signals) {
        try {
          report.signalsKept(SignalFiles.write(recordings(), no, signals));
        } catch (IOException e) {
          LOGGER.log(
              System.Logger.Level.WARNING,
              attempt + ": the signals of case " + no + " cannot be written: " + e);
        }
      }
    };
  }

  /** The attempt was stopped during the download. */
  private static final class StoppedException extends Exception {
    private static final long serialVersionUID = 1L;
  }

  private FileTree download() throws IOException, StoppedException {
    long size = assignment.getFilesList().stream().mapToLong(ApplicationFile::getSize).sum();
    if (size < 0 || size > MAX_APPLICATION_BYTES) {
      throw new IOException("it has " + size + " bytes, but the limit is " + MAX_APPLICATION_BYTES);
    }
    Map<String, byte[]> files = new HashMap<>();
    for (ApplicationFile file : assignment.getFilesList()) {
      files.put(FileTree.requireSafe(file.getPath()), download(file));
    }
    return FileTree.of(files);
  }

  private byte[] download(ApplicationFile file) throws IOException, StoppedException {
    String sha256 = file.getSha256().toLowerCase(Locale.ROOT);
    Backoff backoff = new Backoff();
    int damaged = 0;
    while (true) {
      if (stop.getCount() == 0) {
        throw new StoppedException();
      }
      try {
        Optional<byte[]> content = cache.find(sha256);
        if (content.isPresent()) {
          return content.get();
        }
        download(file, sha256);
        continue;
      } catch (StatusRuntimeException e) {
        if (stop.getCount() == 0) {
          throw new StoppedException();
        }
        if (e.getStatus().getCode() == Status.Code.FAILED_PRECONDITION) {
          abandon();
          throw new StoppedException();
        }
        if (ServerCalls.meaningOf(e) != ServerCalls.Failure.LATER) {
          throw new IOException(file.getPath() + ": " + ServerCalls.describe(e.getStatus()), e);
        }
      } catch (IOException e) {
        if (++damaged == MAX_DAMAGED_DOWNLOADS) {
          throw new IOException(file.getPath() + ": " + e.getMessage(), e);
        }
      }
      pause(backoff);
    }
  }

  private void download(ApplicationFile file, String sha256) throws IOException {
    Context previous = downloadContext.attach();
    try {
      cache.add(sha256, out -> calls.download(attempt, sha256, file.getSize(), out));
    } finally {
      downloadContext.detach(previous);
    }
  }

  private void pause(Backoff backoff) throws StoppedException {
    try {
      if (stop.await(backoff.next().toMillis(), TimeUnit.MILLISECONDS)) {
        throw new StoppedException();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new StoppedException();
    }
  }
}
