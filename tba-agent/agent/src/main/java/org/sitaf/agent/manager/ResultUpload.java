package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import com.google.protobuf.InvalidProtocolBufferException;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.spool.Spool;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.agent.v1.SubmitResultResponse;

/**
 * Brings what is in the spool to the server, for as long as it takes. An entry is deleted only when
 * the server has answered that the attempt has its result, or that the attempt is over.
 */
final class ResultUpload implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration FLUSH = Duration.ofSeconds(3);

  private final Spool spool;
  private final ServerCalls calls;
  private final Map<String, AttemptRef> owed = new ConcurrentHashMap<>();
  private final BackgroundThread thread = new BackgroundThread("sitaf-upload", this::work);
  private boolean news = true;
  private boolean closed;

  /** Begins with what an earlier agent left. */
  ResultUpload(Spool spool, ServerCalls calls) throws IOException {
    this.spool = spool;
    this.calls = calls;
    for (Spool.Entry entry : spool.entries()) {
      SubmitResultRequest message = read(entry);
      if (message != null) {
        owed.put(entry.name(), message.getAttempt());
      }
    }
    thread.start();
  }

  /** Takes over a result; it is safe on the disk when this returns. */
  void add(
      Attempt attempt, SubmitResultRequest message, @Nullable Path log, @Nullable Path recordings)
      throws IOException {
    spool.put(attempt.key(), message.toByteArray(), log, recordings);
    owed.put(attempt.key(), attempt.ref());
    wake();
  }

  /** Attempts whose result the server does not have yet. */
  Collection<AttemptRef> owed() {
    return List.copyOf(owed.values());
  }

  boolean owes(Attempt attempt) {
    return owed.containsKey(attempt.key());
  }

  /** Tries again at once, because the server is there or there is something new. */
  synchronized void wake() {
    news = true;
    notifyAll();
  }

  private void work() {
    Backoff backoff = new Backoff();
    try {
      while (true) {
        boolean complete = uploadAll();
        if (complete) {
          backoff.reset();
        }
        synchronized (this) {
          if (closed && !news) {
            return;
          }
          if (!news) {
            // 0 waits without end: there is nothing to upload.
            wait(complete ? 0 : backoff.next().toMillis());
          }
          if (closed && !news) {
            return;
          }
          news = false;
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Tries each entry once; false when some are left. */
  private boolean uploadAll() throws InterruptedException {
    boolean complete = true;
    try {
      for (Spool.Entry entry : spool.entries()) {
        if (Thread.interrupted()) {
          throw new InterruptedException();
        }
        try {
          complete &= upload(entry);
        } catch (IOException e) {
          // The others do not wait for what cannot be read of this one.
          LOGGER.log(
              System.Logger.Level.WARNING, entry.name() + " in the spool cannot be read: " + e);
          complete = false;
        }
      }
    } catch (IOException e) {
      LOGGER.log(System.Logger.Level.WARNING, "the spool cannot be read: " + e);
      return false;
    }
    return complete;
  }

  private boolean upload(Spool.Entry entry) throws IOException {
    SubmitResultRequest message = read(entry);
    if (message == null) {
      spool.reject(entry);
      return true;
    }
    Attempt attempt = Attempt.of(message.getAttempt());
    try {
      uploadLog(attempt, entry);
      if (!uploadRecordings(attempt, entry)) {
        return false;
      }
      SubmitResultResponse answer = calls.submit(message);
      if (!confirms(answer, message)) {
        LOGGER.log(
            System.Logger.Level.WARNING,
            attempt + ": the server confirms something else than it was sent; sending it again");
        return false;
      }
      LOGGER.log(System.Logger.Level.INFO, attempt + ": " + whatBecameOf(message, answer));
      forget(entry);
      return true;
    } catch (StatusRuntimeException e) {
      return switch (ServerCalls.meaningOf(e)) {
        case LATER -> false;
        case OVER -> {
          LOGGER.log(
              System.Logger.Level.INFO,
              attempt + ": is over: " + ServerCalls.describe(e.getStatus()));
          forget(entry);
          yield true;
        }
        case REFUSED -> refused(entry, attempt, message, e);
      };
    }
  }

  private static String whatBecameOf(SubmitResultRequest sent, SubmitResultResponse answer) {
    if (sent.hasFailure()) {
      return "its failure is noted";
    }
    return answer.getAccepted() ? "accepted, SHA-256 " + sent.getSha256() : "was superseded";
  }

  /** Only what the server has whole, by its size and digest, may be deleted here. */
  private static boolean confirms(SubmitResultResponse answer, SubmitResultRequest sent) {
    return answer.getSha256().equals(sent.getSha256())
        && answer.getSize() == sent.getResultDescriptor().size();
  }

  /**
   * The log first: the result ends the attempt. A log that is refused, or comes too late, does not
   * hold up the result: the server keeps late results for people.
   */
  private void uploadLog(Attempt attempt, Spool.Entry entry) throws IOException {
    try {
      calls.reportState(attempt, AttemptState.ATTEMPT_STATE_UPLOADING);
      long offset = calls.appendLog(attempt, 0, ByteString.EMPTY);
      ByteString chunk = LogFile.chunk(entry.log(), offset);
      while (!chunk.isEmpty()) {
        offset = calls.appendLog(attempt, offset, chunk);
        chunk = LogFile.chunk(entry.log(), offset);
      }
    } catch (StatusRuntimeException e) {
      if (ServerCalls.meaningOf(e) == ServerCalls.Failure.LATER) {
        throw e;
      }
      LOGGER.log(
          System.Logger.Level.WARNING,
          attempt + ": log refused: " + ServerCalls.describe(e.getStatus()));
    }
  }

  /** Those that the server does not have yet, before the result ends the attempt. */
  private boolean uploadRecordings(Attempt attempt, Spool.Entry entry) throws IOException {
    for (Path recording : entry.attachments()) {
      if (!RecordingUpload.upload(attempt, calls, recording)) {
        return false;
      }
    }
    return true;
  }

  /** The result is put aside for a person, and the build ends with the reason instead of never. */
  private boolean refused(
      Spool.Entry entry, Attempt attempt, SubmitResultRequest message, StatusRuntimeException e)
      throws IOException {
    LOGGER.log(
        System.Logger.Level.ERROR,
        attempt + ": the result is refused: " + ServerCalls.describe(e.getStatus()));
    if (message.hasFailure()) {
      spool.reject(entry);
      owed.remove(entry.name());
      return true;
    }
    Path aside = spool.reject(entry);
    String reason = "the server refused the result: " + e.getStatus().getDescription();
    spool.put(
        entry.name(),
        SubmitMessages.infrastructure(attempt, reason).toByteArray(),
        aside.resolve("log"),
        null);
    return false;
  }

  private void forget(Spool.Entry entry) throws IOException {
    spool.delete(entry);
    owed.remove(entry.name());
  }

  private static @Nullable SubmitResultRequest read(Spool.Entry entry) throws IOException {
    Path file = entry.directory();
    try {
      return Files.isDirectory(file) ? SubmitResultRequest.parseFrom(entry.message()) : null;
    } catch (InvalidProtocolBufferException e) {
      LOGGER.log(System.Logger.Level.ERROR, file + " is damaged and is put aside: " + e);
      return null;
    }
  }

  /** Ends; what is still owed has a moment to go, and stays in the spool otherwise. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    thread.end(FLUSH);
  }
}
