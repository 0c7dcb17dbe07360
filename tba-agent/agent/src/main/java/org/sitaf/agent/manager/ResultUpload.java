package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import com.google.protobuf.InvalidProtocolBufferException;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.spool.Spool;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.agent.v1.SubmitResultResponse;

/**
 * Uploads the entries of the spool and retries until the server answers. An entry is deleted only
 * when the server has confirmed the result or reports that the attempt has ended.
 */
final class ResultUpload implements AutoCloseable {
  private static final int MAX_SHOWN = 300;
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration FLUSH = Duration.ofSeconds(3);

  /** Together with the pauses, about one minute. */
  private static final int UNREADABLE_TRIES = 10;

  private final Spool spool;
  private final ServerCalls calls;
  private final Map<String, AttemptRef> pending = new ConcurrentHashMap<>();

  /** Refused assignments, kept in memory, by the key of their attempt. */
  private final Map<String, SubmitResultRequest> refusals = new ConcurrentHashMap<>();

  /** Failed attempts to read an entry, by its name; only the upload thread uses it. */
  private final Map<String, Integer> unreadable = new HashMap<>();

  /** Held while entries and {@link #pending} change together. */
  private final Object entryLock = new Object();

  private final BackgroundThread thread = new BackgroundThread("sitaf-upload", this::work);
  private boolean pendingUpload = true;
  private boolean closed;

  /** Starts with the entries of a previous agent. */
  ResultUpload(Spool spool, ServerCalls calls) throws IOException {
    this.spool = spool;
    this.calls = calls;
    for (Spool.Entry entry : spool.entries()) {
      try {
        pending.put(entry.name(), read(entry).getAttempt());
      } catch (IOException e) {
        LOGGER.log(
            System.Logger.Level.WARNING, entry.name() + " in the spool cannot be read: " + e);
      }
    }
    thread.start();
  }

  /**
   * Adds a result; it is on disk when this returns.
   *
   * @param stored called when the result is on disk and pending, before its upload begins: the
   *     server assigns the next build as soon as it has the result
   */
  void add(
      Attempt attempt,
      SubmitResultRequest message,
      @Nullable Path log,
      @Nullable Path recordings,
      Runnable stored)
      throws IOException {
    synchronized (entryLock) {
      spool.put(attempt.key(), message.toByteArray(), log, recordings);
      pending.put(attempt.key(), attempt.ref());
      stored.run();
    }
    wake();
  }

  /**
   * Adds the refusal of an assignment. It is kept in memory, because the disk may be full and the
   * caller, a gRPC thread, must not block. If the agent ends before the upload, the lease of the
   * attempt expires.
   */
  void refuse(Attempt attempt, SubmitResultRequest failure) {
    refusals.put(attempt.key(), failure);
    pending.put(attempt.key(), attempt.ref());
    wake();
  }

  /** Attempts whose result is not uploaded yet. */
  Collection<AttemptRef> pending() {
    return List.copyOf(pending.values());
  }

  boolean isPending(Attempt attempt) {
    return pending.containsKey(attempt.key());
  }

  /** Retries at once, because the server is available or there is a new entry. */
  synchronized void wake() {
    pendingUpload = true;
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
          if (closed && !pendingUpload) {
            return;
          }
          if (!pendingUpload) {
            // 0 waits without timeout: there is nothing to upload.
            wait(complete ? 0 : backoff.next().toMillis());
          }
          if (closed && !pendingUpload) {
            return;
          }
          pendingUpload = false;
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Tries each entry once; returns false if some are left. */
  private boolean uploadAll() throws InterruptedException {
    boolean complete = uploadRefusals();
    List<Spool.Entry> entries;
    try {
      entries = entries();
    } catch (IOException | RuntimeException e) {
      LOGGER.log(System.Logger.Level.WARNING, "the spool cannot be read: " + e);
      return false;
    }
    for (Spool.Entry entry : entries) {
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      // A failing entry must not block the others.
      try {
        complete &= upload(entry);
        unreadable.remove(entry.name());
      } catch (IOException | RuntimeException e) {
        complete &= failed(entry, e);
      }
    }
    return complete;
  }

  /** Also stops renewing the leases of attempts without an entry, such as rejected ones. */
  private List<Spool.Entry> entries() throws IOException {
    synchronized (entryLock) {
      List<Spool.Entry> entries = spool.entries();
      Set<String> names = entries.stream().map(Spool.Entry::name).collect(Collectors.toSet());
      pending.keySet().removeIf(key -> !names.contains(key) && !refusals.containsKey(key));
      return entries;
    }
  }

  private boolean uploadRefusals() {
    boolean complete = true;
    for (Map.Entry<String, SubmitResultRequest> refusal : refusals.entrySet()) {
      try {
        calls.submit(refusal.getValue());
      } catch (StatusRuntimeException e) {
        if (ServerCalls.meaningOf(e) == ServerCalls.Failure.LATER) {
          complete = false;
          continue;
        }
        LOGGER.log(
            System.Logger.Level.INFO,
            Attempt.of(refusal.getValue().getAttempt())
                + ": the server rejected the refusal: "
                + ServerCalls.describe(e.getStatus()));
      }
      refusals.remove(refusal.getKey());
      pending.remove(refusal.getKey());
    }
    return complete;
  }

  /**
   * Sets an entry aside after repeated failures. The lease of its attempt then expires, and the
   * server assigns the build again. Returns whether the entry is done.
   */
  private boolean failed(Spool.Entry entry, Exception e) {
    int failures = unreadable.merge(entry.name(), 1, Integer::sum);
    if (failures == 1) {
      LOGGER.log(
          System.Logger.Level.WARNING, entry.name() + " in the spool cannot be uploaded: " + e, e);
    }
    if (failures < UNREADABLE_TRIES) {
      return false;
    }
    try {
      putAside(entry);
      unreadable.remove(entry.name());
      LOGGER.log(
          System.Logger.Level.ERROR,
          entry.name() + " in the spool cannot be uploaded and was set aside: " + e);
      return true;
    } catch (IOException | RuntimeException again) {
      LOGGER.log(
          System.Logger.Level.ERROR, entry.name() + " in the spool cannot be set aside: " + again);
      return false;
    }
  }

  private Path putAside(Spool.Entry entry) throws IOException {
    synchronized (entryLock) {
      Path aside = spool.reject(entry);
      pending.remove(entry.name());
      return aside;
    }
  }

  private boolean upload(Spool.Entry entry) throws IOException {
    SubmitResultRequest message;
    try {
      message = read(entry);
    } catch (InvalidProtocolBufferException e) {
      LOGGER.log(
          System.Logger.Level.ERROR, entry.directory() + " is damaged and was set aside: " + e);
      putAside(entry);
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
            attempt + ": the server confirmed different content; retrying");
        return false;
      }
      LOGGER.log(System.Logger.Level.INFO, attempt + ": " + outcomeOf(message, answer));
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

  private static String outcomeOf(SubmitResultRequest sent, SubmitResultResponse answer) {
    if (sent.hasFailure()) {
      return "the failure was stored: " + shown(sent.getFailure().getMessage());
    }
    return answer.getAccepted() ? "accepted, SHA-256 " + sent.getSha256() : "was superseded";
  }

  /** One line of a message that may contain what a component wrote. */
  private static String shown(String message) {
    String line = message.replaceAll("\\p{Cntrl}+", " ").strip();
    return line.substring(0, Math.min(MAX_SHOWN, line.length()));
  }

  /** An entry may be deleted only if the server confirms its size and digest. */
  private static boolean confirms(SubmitResultResponse answer, SubmitResultRequest sent) {
    long size =
        sent.hasAnalysis()
            ? sent.getAnalysis().getSerializedSize()
            : sent.getResultDescriptor().size();
    return answer.getSha256().equals(sent.getSha256()) && answer.getSize() == size;
  }

  /**
   * Uploads the log before the result, which ends the attempt. A rejected log does not block the
   * result, because the server stores late results, too.
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
      putAside(entry);
      return true;
    }
    String reason = "the server refused the result: " + e.getStatus().getDescription();
    synchronized (entryLock) {
      spool.replace(entry, SubmitMessages.infrastructure(attempt, reason).toByteArray());
    }
    return false;
  }

  private void forget(Spool.Entry entry) throws IOException {
    synchronized (entryLock) {
      spool.delete(entry);
      pending.remove(entry.name());
    }
  }

  private static SubmitResultRequest read(Spool.Entry entry) throws IOException {
    return SubmitResultRequest.parseFrom(entry.message());
  }

  /** Ends; what is still pending has a moment to go, and stays in the spool otherwise. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    thread.end(FLUSH);
  }
}
