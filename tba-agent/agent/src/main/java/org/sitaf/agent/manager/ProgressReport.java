package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.core.verdict.CaseResult;

/**
 * Tells the server how an attempt goes, from a thread of its own, so that a slow server never slows
 * a build. What is not told when the build ends does not matter: log and result go with the spool.
 */
final class ProgressReport implements BuildListener, AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final int CASES_PER_MESSAGE = 500;
  private static final long MAX_BATCH_BYTES = 1 << 20;
  private static final Duration PAUSE = Duration.ofMillis(100);
  private static final Duration FLUSH = Duration.ofSeconds(2);

  private final Attempt attempt;
  private final ServerCalls calls;
  private final Path log;
  private final Runnable whenOver;
  private final RecordingUpload recordings;
  private final BackgroundThread thread;

  private @Nullable AttemptState state;
  private final List<CaseResult> cases = new ArrayList<>();
  private boolean logGrew;
  private boolean closed;

  /** Only the reporting thread's. */
  private long logOffset;

  private long nextBatch = 1;
  private List<CaseOutcome> batch = List.of();

  /**
   * Begins to report.
   *
   * @param directory the build's
   * @param recordings takes what moved in the cases; the caller closes it
   * @param whenOver what to do when the server says that the attempt is over
   */
  ProgressReport(
      Attempt attempt,
      ServerCalls calls,
      Path directory,
      RecordingUpload recordings,
      Runnable whenOver) {
    this.attempt = attempt;
    this.calls = calls;
    this.log = directory.resolve(BuildRun.LOG);
    this.recordings = recordings;
    this.whenOver = whenOver;
    this.thread = new BackgroundThread("sitaf-progress", this::work);
    thread.start();
  }

  @Override
  public synchronized void stage(BuildStage stage) {
    AttemptState now =
        switch (stage) {
          case PREPARING -> AttemptState.ATTEMPT_STATE_PREPARING;
          case COMPILING -> AttemptState.ATTEMPT_STATE_COMPILING;
          case RUNNING -> AttemptState.ATTEMPT_STATE_RUNNING;
        };
    state = now;
    notifyAll();
  }

  @Override
  public synchronized void log(byte[] utf8) {
    logGrew = true;
    notifyAll();
  }

  @Override
  public synchronized void caseFinished(CaseResult result) {
    cases.add(result);
    notifyAll();
  }

  @Override
  public void recorded(int no, Path recording) {
    recordings.add(recording);
  }

  private void work() {
    Backoff backoff = new Backoff();
    try {
      while (awaitNews()) {
        Duration pause = PAUSE;
        try {
          tell();
          backoff.reset();
        } catch (StatusRuntimeException e) {
          switch (ServerCalls.meaningOf(e)) {
            case OVER -> {
              whenOver.run();
              return;
            }
            case LATER -> pause = backoff.next();
            case REFUSED -> refused(e);
          }
        } catch (IOException e) {
          LOGGER.log(System.Logger.Level.WARNING, attempt + ": the log cannot be read: " + e);
        }
        pause(pause);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * What the server will never take is not told again; the log goes on where the server has its
   * end.
   */
  private void refused(StatusRuntimeException e) {
    LOGGER.log(
        System.Logger.Level.WARNING,
        attempt + ": progress refused: " + ServerCalls.describe(e.getStatus()));
    synchronized (this) {
      state = null;
      cases.clear();
      logGrew = false;
    }
    batch = List.of();
    if (e.getStatus().getCode() == Status.Code.OUT_OF_RANGE) {
      logOffset = 0;
    }
  }

  private synchronized boolean awaitNews() throws InterruptedException {
    while (state == null && cases.isEmpty() && !logGrew) {
      if (closed) {
        return false;
      }
      wait();
    }
    return true;
  }

  /**
   * News that come meanwhile wait for the next message; the end of the build cuts the pause short.
   */
  private synchronized void pause(Duration duration) throws InterruptedException {
    long end = System.nanoTime() + duration.toNanos();
    for (long left = duration.toMillis();
        left > 0 && !(closed && duration.equals(PAUSE));
        left = (end - System.nanoTime()) / 1_000_000) {
      wait(left);
    }
  }

  /** As many from the first on as a message holds; one holds a case, however large. */
  private static List<CaseOutcome> fitting(List<CaseResult> ended) {
    List<CaseOutcome> fitting = new ArrayList<>();
    long size = 0;
    for (CaseResult result : ended) {
      CaseOutcome outcome = CaseOutcomes.of(result);
      size += outcome.getSerializedSize();
      if (size > MAX_BATCH_BYTES && !fitting.isEmpty()) {
        break;
      }
      fitting.add(outcome);
    }
    return fitting;
  }

  private void tell() throws IOException {
    AttemptState newState;
    List<CaseResult> ended = List.of();
    synchronized (this) {
      newState = state;
      if (batch.isEmpty()) {
        ended = List.copyOf(cases.subList(0, Math.min(cases.size(), CASES_PER_MESSAGE)));
      }
      logGrew = false;
    }
    if (batch.isEmpty()) {
      batch = fitting(ended);
    }
    if (newState != null) {
      calls.reportState(attempt, newState);
      synchronized (this) {
        state = state == newState ? null : state;
      }
    }
    if (!batch.isEmpty()) {
      // A batch that was not answered is sent again as it was, under its number.
      calls.reportCases(attempt, nextBatch, batch);
      synchronized (this) {
        cases.subList(0, batch.size()).clear();
      }
      batch = List.of();
      nextBatch++;
    }
    try {
      tellLog();
    } catch (StatusRuntimeException e) {
      synchronized (this) {
        logGrew = true;
      }
      throw e;
    }
  }

  private void tellLog() throws IOException {
    ByteString chunk = LogFile.chunk(log, logOffset);
    while (!chunk.isEmpty()) {
      logOffset = calls.appendLog(attempt, logOffset, chunk);
      chunk = LogFile.chunk(log, logOffset);
    }
  }

  /** Ends reporting; what is still to tell has a moment to be told. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    thread.end(FLUSH);
  }
}
