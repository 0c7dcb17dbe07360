package org.sitaf.agent.manager;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.spool.BuildFolders;
import org.sitaf.agent.spool.FileCache;
import org.sitaf.agent.spool.FreeSpace;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.Cancellation;
import org.sitaf.agent.v1.SubmitResultRequest;

/** Runs the assigned attempts, each in its own thread, up to the number of slots. */
final class Attempts {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");

  private final int slots;
  private final BuildFolders builds;
  private final BuildSettings settings;
  private final ServerCalls calls;
  private final FileCache cache;
  private final ResultUpload upload;
  private final FreeSpace disk;
  private final Runnable onFull;
  private final Map<String, AttemptRun> running = new HashMap<>();
  private final List<Thread> threads = new ArrayList<>();
  private boolean stopping;

  /**
   * Creates the pool without attempts.
   *
   * @param onFull called if the agent cannot accept builds at present, so that the server is
   *     informed before it retries a build
   */
  Attempts(
      int slots,
      BuildFolders builds,
      BuildSettings settings,
      ServerCalls calls,
      FileCache cache,
      ResultUpload upload,
      FreeSpace disk,
      Runnable onFull) {
    this.slots = slots;
    this.builds = builds;
    this.settings = settings;
    this.calls = calls;
    this.cache = cache;
    this.upload = upload;
    this.disk = disk;
    this.onFull = onFull;
  }

  /** Starts an attempt, unless it is running or its result is waiting for upload. */
  void begin(Assignment assignment) {
    Attempt attempt = Attempt.of(assignment.getAttempt());
    if (upload.isPending(attempt)) {
      return;
    }
    String full = disk.whyFull();
    if (!full.isEmpty()) {
      onFull.run();
      upload.refuse(attempt, SubmitMessages.infrastructure(attempt, "the agent is full: " + full));
      return;
    }
    if (!takeSlot(attempt, assignment)) {
      upload.refuse(attempt, SubmitMessages.infrastructure(attempt, "the agent has no free slot"));
    }
  }

  /**
   * Returns false if there is no free slot. Must not access the disk, because heartbeats wait for
   * the lock.
   */
  private synchronized boolean takeSlot(Attempt attempt, Assignment assignment) {
    if (stopping || running.containsKey(attempt.key())) {
      return true;
    }
    if (running.size() >= slots) {
      return false;
    }
    AttemptRun run =
        new AttemptRun(attempt, assignment, builds.of(attempt.key()), settings, calls, cache);
    running.put(attempt.key(), run);
    threads.removeIf(thread -> !thread.isAlive());
    Thread thread = new Thread(() -> work(run), "sitaf-build");
    threads.add(thread);
    thread.start();
    return true;
  }

  private synchronized void releaseSlot(Attempt attempt) {
    running.remove(attempt.key());
  }

  /** Cancels an attempt; an unknown attempt is reported as cancelled. */
  void cancel(Cancellation cancellation) {
    Attempt attempt = Attempt.of(cancellation.getAttempt());
    Optional<AttemptRun> run;
    synchronized (this) {
      run = Optional.ofNullable(running.get(attempt.key()));
    }
    if (run.isPresent() && cancellation.getGivenUp()) {
      run.get().abandon();
    } else if (run.isPresent()) {
      run.get().cancel(cancellation.getReason());
    } else if (!upload.isPending(attempt)) {
      BuildOutcome cancelled = new BuildOutcome.Cancelled(cancellation.getReason());
      upload.refuse(attempt, SubmitMessages.of(attempt, cancelled));
    }
  }

  /**
   * Stops the attempts that use real devices: a server may have assigned their builds again, and
   * cannot cancel them any more.
   */
  void stopWithDevices() {
    List<AttemptRun> stopped;
    synchronized (this) {
      stopped = running.values().stream().filter(AttemptRun::usesDevices).toList();
    }
    stopped.forEach(
        run -> {
          LOGGER.log(
              System.Logger.Level.WARNING,
              run.attempt() + ": stopped, because it uses real devices and its lease was lost");
          run.stopForAgent();
        });
  }

  /** The attempts to report to the server. */
  List<AttemptRef> refs() {
    List<AttemptRef> refs = new ArrayList<>(upload.pending());
    synchronized (this) {
      running.values().forEach(run -> refs.add(run.attempt().ref()));
    }
    return refs.stream().distinct().toList();
  }

  private void work(AttemptRun run) {
    Attempt attempt = run.attempt();
    Path directory = builds.of(attempt.key());
    LOGGER.log(System.Logger.Level.INFO, attempt + ": started");
    try {
      builds.create(attempt.key());
      Optional<BuildOutcome> outcome = run.run();
      if (!disk.whyFull().isEmpty()) {
        onFull.run();
      }
      outcome.ifPresentOrElse(
          ended ->
              keepResult(
                  attempt,
                  SubmitMessages.of(attempt, ended),
                  directory.resolve(BuildRun.LOG),
                  ended instanceof BuildOutcome.Completed ? run.recordings() : null),
          () -> LOGGER.log(System.Logger.Level.INFO, attempt + ": was abandoned"));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException | RuntimeException | Error e) {
      LOGGER.log(System.Logger.Level.ERROR, attempt + ": internal error of the agent", e);
      keepResult(
          attempt,
          SubmitMessages.infrastructure(attempt, "internal error of the agent: " + e),
          null,
          null);
    } finally {
      releaseSlot(attempt);
      try {
        builds.remove(attempt.key());
      } catch (IOException e) {
        LOGGER.log(System.Logger.Level.WARNING, directory + " cannot be deleted: " + e);
      }
    }
  }

  /**
   * Stores a result in the spool and retries until the agent stops. The attempt keeps its slot
   * meanwhile.
   */
  private void keepResult(
      Attempt attempt, SubmitResultRequest message, @Nullable Path log, @Nullable Path recordings) {
    Backoff backoff = new Backoff();
    while (true) {
      try {
        upload.add(attempt, message, log, recordings, () -> releaseSlot(attempt));
        return;
      } catch (IOException e) {
        LOGGER.log(System.Logger.Level.ERROR, attempt + ": the spool cannot be written: " + e);
      }
      try {
        Thread.sleep(backoff.next().toMillis());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  /** Stops all attempts and waits until they have ended. */
  void stop(Duration atMost) {
    List<AttemptRun> stopped;
    List<Thread> left;
    synchronized (this) {
      stopping = true;
      stopped = List.copyOf(running.values());
      left = List.copyOf(threads);
    }
    stopped.forEach(AttemptRun::stopForAgent);
    long end = System.nanoTime() + atMost.toNanos();
    try {
      for (Thread thread : left) {
        thread.join(Math.max(1, (end - System.nanoTime()) / 1_000_000));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
