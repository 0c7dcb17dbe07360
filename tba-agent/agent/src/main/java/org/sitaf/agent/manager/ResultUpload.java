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
 * Brings what is in the spool to the server, for as long as it takes. An entry is deleted only when
 * the server has answered that the attempt has its result, or that the attempt is over.
 */
final class ResultUpload implements AutoCloseable {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");
  private static final Duration FLUSH = Duration.ofSeconds(3);

  /** With the pauses between them about a minute. */
  private static final int UNREADABLE_TRIES = 10;

  private final Spool spool;
  private final ServerCalls calls;
  private final Map<String, AttemptRef> pending = new ConcurrentHashMap<>();

  /** Short answers that need no disk, by the key of their attempt. */
  private final Map<String, SubmitResultRequest> refusals = new ConcurrentHashMap<>();

  /** Failed attempts to read an entry, by its name; only the upload thread uses it. */
  private final Map<String, Integer> unreadable = new HashMap<>();

  /** Held while entries and {@link #pending} change together. */
  private final Object entryLock = new Object();

  private final BackgroundThread thread = new BackgroundThread("sitaf-upload", this::work);
  private boolean news = true;
  private boolean closed;

  /** Begins with what an earlier agent left. */
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

  /** Takes over a result; it is safe on the disk when this returns. */
  void add(
      Attempt attempt, SubmitResultRequest message, @Nullable Path log, @Nullable Path recordings)
      throws IOException {
    synchronized (entryLock) {
      spool.put(attempt.key(), message.toByteArray(), log, recordings);
      pending.put(attempt.key(), attempt.ref());
    }
    wake();
  }

  /**
   * Takes over the answer to an assignment that the agent does not accept. It stays in memory: the
   * disk may be full, and the caller, a thread of gRPC, must not wait. When the agent ends before
   * the server has the answer, the lease of the attempt expires.
   */
  void refuse(Attempt attempt, SubmitResultRequest failure) {
    refusals.put(attempt.key(), failure);
    pending.put(attempt.key(), attempt.ref());
    wake();
  }

  /** Attempts whose result the server does not have yet. */
  Collection<AttemptRef> pending() {
    return List.copyOf(pending.values());
  }

  boolean isPending(Attempt attempt) {
    return pending.containsKey(attempt.key());
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
      // An entry that fails must not keep the others from the server.
      try {
        complete &= upload(entry);
        unreadable.remove(entry.name());
      } catch (IOException | RuntimeException e) {
        complete &= failed(entry, e);
      }
    }
    return complete;
  }

  /** Also ends the leases of attempts whose entries are gone, such as those put aside. */
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
                + ": the server does not take its refusal: "
                + ServerCalls.describe(e.getStatus()));
      }
      refusals.remove(refusal.getKey());
      pending.remove(refusal.getKey());
    }
    return complete;
  }

  /**
   * An entry that stays unreadable is put aside. The lease of its attempt then expires, and the
   * server gives the build to an agent again. True when nothing is left to do for it.
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
          entry.name() + " in the spool cannot be uploaded and is put aside: " + e);
      return true;
    } catch (IOException | RuntimeException again) {
      LOGGER.log(
          System.Logger.Level.ERROR, entry.name() + " in the spool cannot be put aside: " + again);
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
          System.Logger.Level.ERROR, entry.directory() + " is damaged and is put aside: " + e);
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
