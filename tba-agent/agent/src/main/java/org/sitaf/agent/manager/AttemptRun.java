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
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.build.RecordingOrder.Cases;
import org.sitaf.agent.spool.FileCache;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.v1.ApplicationFile;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.RecordingOrder;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.CaseResult;

/** One attempt from its assignment to an outcome: fetches the test application and builds it. */
final class AttemptRun {
  private static final long MAX_APPLICATION_BYTES = 512L << 20;
  private static final int MAX_RECORDINGS = 100_000;
  private static final int DAMAGED_TRIES = 3;
  private static final long CATCHING_UP_MS = 2000;

  private final Attempt attempt;
  private final Assignment assignment;
  private final Path directory;
  private final BuildSettings settings;
  private final ServerCalls calls;
  private final FileCache cache;

  private final Context.CancellableContext fetching = Context.ROOT.withCancellation();
  private final CountDownLatch stop = new CountDownLatch(1);
  private @Nullable String stopReason;
  private boolean stoppedByAgent;
  private boolean over;
  private int casesLeft = Integer.MAX_VALUE;
  private @Nullable BuildRun build;

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

  /** Where recordings lie that the server does not have yet; need not be there. */
  Path recordings() {
    return directory.resolve("recordings");
  }

  /** Somebody does not want the build any more. */
  void cancel(String reason) {
    stop(reason);
  }

  /** The agent ends; the build itself is still wanted. */
  void stopForAgent() {
    synchronized (this) {
      stoppedByAgent = stopReason == null;
    }
    stop("the agent was stopped");
  }

  /**
   * The attempt belongs to somebody else by now: only a result that is all but ready is kept, as
   * the server keeps late ones for people.
   */
  void giveUp() {
    synchronized (this) {
      if (over) {
        return;
      }
      over = true;
    }
    Thread later = new Thread(this::stopUnlessAllCasesEnded, "sitaf-give-up");
    later.setDaemon(true);
    later.start();
  }

  /** An agent that was silent has a moment to see how far its test application came meanwhile. */
  private void stopUnlessAllCasesEnded() {
    try {
      Thread.sleep(CATCHING_UP_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    synchronized (this) {
      if (casesLeft == 0) {
        return;
      }
    }
    stop("the attempt is over");
  }

  private void stop(String reason) {
    BuildRun running;
    synchronized (this) {
      if (stopReason == null) {
        stopReason = reason;
      }
      running = build;
    }
    stop.countDown();
    fetching.cancel(null);
    if (running != null) {
      running.cancel(reason);
    }
  }

  /** Does the work; empty when nothing of the attempt is to be kept. */
  Optional<BuildOutcome> run() {
    BuildOutcome outcome;
    try (RecordingUpload recordings = new RecordingUpload(attempt, calls);
        ProgressReport report =
            new ProgressReport(attempt, calls, directory, recordings, this::giveUp)) {
      report.stage(BuildStage.PREPARING);
      outcome = fetchAndBuild(report);
    }
    synchronized (this) {
      if (over && !(outcome instanceof BuildOutcome.Completed)) {
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
    return switch (order.getCases()) {
      case FAILED -> recorded(order, Cases.FAILED);
      case ALL -> recorded(order, Cases.ALL);
      case CASES_UNSPECIFIED, UNRECOGNIZED -> settings;
    };
  }

  private BuildSettings recorded(RecordingOrder order, Cases cases) {
    return settings.recording(
        new org.sitaf.agent.build.RecordingOrder(
            recordings(),
            cases,
            (int) Math.min(Integer.toUnsignedLong(order.getMaxRecordings()), MAX_RECORDINGS),
            Math.max(0, order.getMaxBytes())));
  }

  private BuildOutcome fetchAndBuild(ProgressReport report) {
    try {
      TestApplication application = TestApplication.read(fetch());
      BuildRun run = new BuildRun(application, directory, recorded(), counting(report));
      synchronized (this) {
        build = run;
        casesLeft = application.suite().cases().size();
        if (stopReason != null) {
          return new BuildOutcome.Cancelled(stopReason);
        }
      }
      try {
        return run.run();
      } finally {
        // The next build of the language finds its compiler ready.
        settings
            .toolchains()
            .startAhead(application.activity().profile().harness(), settings.sandbox());
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
          "the test application cannot be fetched: " + e.getMessage());
    }
  }

  /** Tells the report, and knows how many cases are still to come. */
  private BuildListener counting(ProgressReport report) {
    return new BuildListener() {
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
      }

      @Override
      public void recorded(int no, Path recording) {
        report.recorded(no, recording);
      }
    };
  }

  /** The attempt was stopped while it was fetched. */
  private static final class StoppedException extends Exception {
    private static final long serialVersionUID = 1L;
  }

  private FileTree fetch() throws IOException, StoppedException {
    long size = assignment.getFilesList().stream().mapToLong(ApplicationFile::getSize).sum();
    if (size < 0 || size > MAX_APPLICATION_BYTES) {
      throw new IOException(
          "it has " + size + " bytes; at most " + MAX_APPLICATION_BYTES + " are taken");
    }
    Map<String, byte[]> files = new HashMap<>();
    for (ApplicationFile file : assignment.getFilesList()) {
      files.put(FileTree.requireSafe(file.getPath()), fetch(file));
    }
    return FileTree.of(files);
  }

  private byte[] fetch(ApplicationFile file) throws IOException, StoppedException {
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
          giveUp();
          throw new StoppedException();
        }
        if (ServerCalls.meaningOf(e) != ServerCalls.Failure.LATER) {
          throw new IOException(file.getPath() + ": " + ServerCalls.describe(e.getStatus()), e);
        }
      } catch (IOException e) {
        if (++damaged == DAMAGED_TRIES) {
          throw new IOException(file.getPath() + ": " + e.getMessage(), e);
        }
      }
      pause(backoff);
    }
  }

  private void download(ApplicationFile file, String sha256) throws IOException {
    Context previous = fetching.attach();
    try {
      cache.add(sha256, out -> calls.download(attempt, sha256, file.getSize(), out));
    } finally {
      fetching.detach(previous);
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
