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
 * Reports the progress of an attempt to the server in a background thread, so that a slow server
 * never slows a build. Nothing is lost if the build ends before all is reported, because log and
 * result are uploaded from the spool.
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
  private final Runnable onAttemptEnded;
  private final RecordingUpload recordings;
  private final BackgroundThread thread;

  private @Nullable AttemptState state;
  private final List<CaseResult> cases = new ArrayList<>();
  private boolean logGrew;
  private boolean closed;

  /** Used by the reporting thread only. */
  private long logOffset;

  private long nextBatch = 1;
  private List<CaseOutcome> batch = List.of();

  /**
   * Starts to report.
   *
   * @param directory folder of the build
   * @param recordings uploads recordings and signals; closed by the caller
   * @param onAttemptEnded called when the server reports that the attempt has ended
   */
  ProgressReport(
      Attempt attempt,
      ServerCalls calls,
      Path directory,
      RecordingUpload recordings,
      Runnable onAttemptEnded) {
    this.attempt = attempt;
    this.calls = calls;
    this.log = directory.resolve(BuildRun.LOG);
    this.recordings = recordings;
    this.onAttemptEnded = onAttemptEnded;
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

  @Override
  public void secondRunRecorded(int no, int relation, Path recording) {
    recordings.add(recording);
  }

  /** The signals of a case are in this file. */
  void signalsKept(Path file) {
    recordings.add(file);
  }

  private void work() {
    Backoff backoff = new Backoff();
    try {
      while (awaitEvents()) {
        Duration pause = PAUSE;
        try {
          send();
          backoff.reset();
        } catch (StatusRuntimeException e) {
          switch (ServerCalls.meaningOf(e)) {
            case OVER -> {
              onAttemptEnded.run();
              return;
            }
            case LATER -> pause = backoff.next();
            case REFUSED -> rejected(e);
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

  /** Skips what the server rejects; the log continues at the server's offset. */
  private void rejected(StatusRuntimeException e) {
    LOGGER.log(
        System.Logger.Level.WARNING,
        attempt + ": progress rejected: " + ServerCalls.describe(e.getStatus()));
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

  private synchronized boolean awaitEvents() throws InterruptedException {
    while (state == null && cases.isEmpty() && !logGrew) {
      if (closed) {
        return false;
      }
      wait();
    }
    return true;
  }

  /** Collects further events into the next message; the end of the build ends the pause. */
  private synchronized void pause(Duration duration) throws InterruptedException {
    long end = System.nanoTime() + duration.toNanos();
    for (long left = duration.toMillis();
        left > 0 && !(closed && duration.equals(PAUSE));
        left = (end - System.nanoTime()) / 1_000_000) {
      wait(left);
    }
  }

  /** As many cases as fit into a message, at least one. */
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

  private void send() throws IOException {
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
      // A batch without response is sent again unchanged with the same sequence number.
      calls.reportCases(attempt, nextBatch, batch);
      synchronized (this) {
        cases.subList(0, batch.size()).clear();
      }
      batch = List.of();
      nextBatch++;
    }
    try {
      sendLog();
    } catch (StatusRuntimeException e) {
      synchronized (this) {
        logGrew = true;
      }
      throw e;
    }
  }

  private void sendLog() throws IOException {
    ByteString chunk = LogFile.chunk(log, logOffset);
    while (!chunk.isEmpty()) {
      logOffset = calls.appendLog(attempt, logOffset, chunk);
      chunk = LogFile.chunk(log, logOffset);
    }
  }

  /** Stops reporting after a last attempt to send the rest. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    thread.end(FLUSH);
  }
}
