package org.sitaf.agent.manager;

import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * Brings the recordings of a running attempt to the server, each as soon as it is there, for people
 * who watch. A file that the server has, or will never take, is deleted: what is left in the end
 * goes with the spool.
 */
final class RecordingUpload implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final String SUFFIX = ".glb";
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
   * Takes a recording.
   *
   * @param file {@code NO.glb}
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

  /** Null when there is nothing more to do. */
  private synchronized @Nullable Path next() throws InterruptedException {
    while (waiting.isEmpty() && !closed) {
      wait();
    }
    return waiting.poll();
  }

  /** Where the server is away at the end of the build, the spool waits for it, not the build. */
  private synchronized void putBack(Path file, Duration pause) throws InterruptedException {
    if (closed) {
      waiting.clear();
      return;
    }
    waiting.addFirst(file);
    wait(pause.toMillis());
  }

  /**
   * Gives a recording to the server.
   *
   * @param file {@code NO.glb}
   * @return whether there is nothing more to do for it, in which case its file is deleted
   */
  static boolean upload(Attempt attempt, ServerCalls calls, Path file) throws IOException {
    String name = file.getFileName().toString();
    int no = Integer.parseInt(name.substring(0, name.length() - SUFFIX.length()));
    try {
      calls.uploadRecording(attempt, no, Files.readAllBytes(file));
    } catch (StatusRuntimeException e) {
      if (ServerCalls.meaningOf(e) == ServerCalls.Failure.LATER) {
        return false;
      }
      LOGGER.log(
          System.Logger.Level.WARNING,
          attempt
              + ": the recording of case "
              + no
              + " is not taken: "
              + ServerCalls.describe(e.getStatus()));
    }
    Files.delete(file);
    return true;
  }

  /** Ends; what is still to be sent has a moment to go. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    // What it has in its hand is either there or not before the spool looks.
    thread.endSurely(FLUSH);
  }
}
