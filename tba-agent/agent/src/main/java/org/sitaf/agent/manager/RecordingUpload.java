package org.sitaf.agent.manager;

import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.RecordingFile;
import org.sitaf.agent.v1.CaseSignals;

/**
 * Uploads the recordings and signals of a running attempt for the live view. Files that the server
 * has stored or rejected are deleted; the rest is uploaded from the spool.
 */
final class RecordingUpload implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration FLUSH = Duration.ofSeconds(2);

  private final Attempt attempt;
  private final ServerCalls calls;
  private final Deque<Path> waiting = new ArrayDeque<>();
  private final BackgroundThread thread =
      new BackgroundThread("sitaf-recording-upload", this::work);
  private boolean closed;

  RecordingUpload(Attempt attempt, ServerCalls calls) {
    this.attempt = attempt;
    this.calls = calls;
    thread.start();
  }

  /**
   * Adds a file.
   *
   * @param file a recording or {@code NO.signals}
   */
  synchronized void add(Path file) {
    waiting.add(file);
    notifyAll();
  }

  private void work() {
    Backoff backoff = new Backoff();
    try {
      for (Path next = next(); next != null; next = next()) {
        if (upload(attempt, calls, next)) {
          backoff.reset();
        } else {
          putBack(next, backoff.next());
        }
      }
    } catch (IOException e) {
      LOGGER.log(System.Logger.Level.WARNING, attempt + ": a recording cannot be read: " + e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Null if there is nothing more to do. */
  private synchronized @Nullable Path next() throws InterruptedException {
    while (waiting.isEmpty() && !closed) {
      wait();
    }
    return waiting.poll();
  }

  /** Retries later; at the end of the build the file stays for the spool instead. */
  private synchronized void putBack(Path file, Duration pause) throws InterruptedException {
    if (closed) {
      waiting.clear();
      return;
    }
    waiting.addFirst(file);
    wait(pause.toMillis());
  }

  /**
   * Uploads a recording or the signals of a case.
   *
   * @param file a recording or {@code NO.signals}
   * @return whether the upload is complete and the file deleted
   */
  static boolean upload(Attempt attempt, ServerCalls calls, Path file) throws IOException {
    String name = file.getFileName().toString();
    boolean isRecording = RecordingFile.isRecording(name);
    RecordingFile of =
        isRecording
            ? RecordingFile.of(name)
            : new RecordingFile(
                Integer.parseInt(name.substring(0, name.length() - SignalFiles.SUFFIX.length())),
                0);
    byte[] content = Files.readAllBytes(file);
    try {
      if (isRecording) {
        calls.uploadRecording(attempt, of, content);
      } else {
        calls.uploadSignals(attempt, of.no(), CaseSignals.parseFrom(content));
      }
    } catch (StatusRuntimeException e) {
      if (ServerCalls.meaningOf(e) == ServerCalls.Failure.LATER) {
        return false;
      }
      LOGGER.log(
          System.Logger.Level.WARNING,
          "%s: the server rejected the %s of case %d: %s"
              .formatted(
                  attempt,
                  isRecording ? "recording" : "signals",
                  of.no(),
                  ServerCalls.describe(e.getStatus())));
    }
    Files.delete(file);
    return true;
  }

  /** Stops after a last attempt to upload the rest. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    // Wait for the current upload, so that the spool does not see a file that is being deleted.
    thread.endSurely(FLUSH);
  }
}
