package org.sitaf.server.git.commit;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.git.remote.RemoteException;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.git.source.SourceChanged;
import org.sitaf.server.git.source.SourceDeleted;
import org.sitaf.server.git.source.SourceRows;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.SmartLifecycle;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Service;

/**
 * Fetches sources and builds their commits, each source in a thread of its own, so that a slow
 * repository delays no other one.
 */
@Service
public class Fetches implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(Fetches.class);
  private static final Duration CLAIM = Duration.ofSeconds(60);
  private static final int RENEW_S = 15;
  private static final int BUSY_S = 5;
  private static final int CHECK_S = 30;

  /** What is fetched besides the branch, within the same claim of the source. */
  public interface Heads {
    /** Fetches what has to be fetched; a problem is stored and does not stop the branch. */
    Recording fetch(GitSource source);
  }

  /** Records commits of what was fetched, after those of the branch. */
  @FunctionalInterface
  public interface Recording {
    void record(GitSource source);
  }

  private final SourceRows rows;
  private final GitSources sources;
  private final CommitBuilds builds;
  private final Heads heads;
  private final CommitRows commits;
  private final Polling polling;
  private final DiskSpace disk;
  private final int atOnce;

  /** What to do for a source; a fetch includes what follows from it. */
  private final Map<String, Boolean> requested = new ConcurrentHashMap<>();

  private final Set<String> working = ConcurrentHashMap.newKeySet();
  private ExecutorService threads = Executors.newSingleThreadExecutor();
  private ScheduledExecutorService timer = DaemonTimer.named("git-claims");
  private volatile boolean running;

  Fetches(
      SourceRows rows,
      GitSources sources,
      CommitBuilds builds,
      Heads heads,
      CommitRows commits,
      Polling polling,
      DiskSpace disk,
      GitSettings settings) {
    this.rows = rows;
    this.sources = sources;
    this.builds = builds;
    this.heads = heads;
    this.commits = commits;
    this.polling = polling;
    this.disk = disk;
    this.atOnce = settings.fetchesAtOnce();
    threads.shutdown();
  }

  /** Fetches a source soon. Requests that come while it waits are one. */
  public void request(String sourceId) {
    request(sourceId, true);
  }

  /** Builds commits of a source that wait, and fetches the heads of its requests. */
  public void requestBuilds(String sourceId) {
    request(sourceId, false);
  }

  private void request(String sourceId, boolean fetch) {
    boolean isNew = requested.merge(sourceId, fetch, Boolean::logicalOr) != null;
    if (isNew && running) {
      submit(sourceId);
    }
  }

  private void submit(String sourceId) {
    try {
      threads.execute(() -> work(sourceId));
    } catch (RejectedExecutionException e) {
      log.debug("The server stops; source {} is fetched later", sourceId, e);
    }
  }

  private void work(String sourceId) {
    if (!working.add(sourceId)) {
      // The thread that works on it looks for further requests when it ends.
      return;
    }
    boolean again = false;
    try {
      if (!rows.claim(sourceId, CLAIM)) {
        again = rows.find(sourceId).isPresent();
        return;
      }
      try {
        for (Boolean fetch = requested.remove(sourceId);
            fetch != null;
            fetch = requested.remove(sourceId)) {
          run(sourceId, fetch);
        }
      } finally {
        rows.release(sourceId);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (Exception e) {
      // The source may have been deleted in the meantime.
      again = rows.find(sourceId).isPresent();
      if (running && again) {
        log.error("The commits of source {} cannot be read; retrying", sourceId, e);
      }
    } finally {
      working.remove(sourceId);
      if (again) {
        later(sourceId);
      } else if (requested.containsKey(sourceId)) {
        submit(sourceId);
      }
    }
  }

  private void later(String sourceId) {
    try {
      var unused = timer.schedule(() -> request(sourceId, false), BUSY_S, TimeUnit.SECONDS);
    } catch (RejectedExecutionException e) {
      log.debug("The server stops", e);
    }
  }

  private void run(String sourceId, boolean fetch) throws IOException, InterruptedException {
    GitSource source = rows.find(sourceId).orElse(null);
    if (source == null) {
      return;
    }
    if (fetch) {
      try {
        sources.fetch(source, List.of());
      } catch (RemoteException e) {
        log.debug("Source {} cannot be fetched", sourceId, e);
        rows.failed(sourceId, e.text());
      }
    }
    Recording recording = heads.fetch(source);
    builds.record(source);
    GitSource updated = rows.find(sourceId).orElse(null);
    if (updated != null) {
      recording.record(updated);
      builds.buildWaiting(updated);
    }
  }

  @EventListener
  void on(SourceChanged change) {
    polling.schedule(change.sourceId(), change.intervalS());
    request(change.sourceId());
  }

  @EventListener
  void on(SourceDeleted deleted) {
    polling.remove(deleted.sourceId());
  }

  /** Finds what a server that died has left, and claims what this one works on for longer. */
  private void check() {
    if (disk.canWrite()) {
      commits.sourcesWithWaiting().stream()
          .filter(id -> !working.contains(id))
          .forEach(this::requestBuilds);
    }
  }

  @Override
  public void start() {
    threads = Executors.newFixedThreadPool(atOnce, Fetches::thread);
    timer = DaemonTimer.named("git-claims");
    running = true;
    var unused =
        timer.scheduleWithFixedDelay(
            safely(() -> working.forEach(id -> rows.claim(id, CLAIM))),
            RENEW_S,
            RENEW_S,
            TimeUnit.SECONDS);
    unused = timer.scheduleWithFixedDelay(safely(this::check), 1, CHECK_S, TimeUnit.SECONDS);
    rows.all().forEach(source -> polling.schedule(source.id(), source.intervalS()));
    requested.keySet().forEach(this::submit);
  }

  private static Thread thread(Runnable task) {
    Thread thread = new Thread(task, "git-fetch");
    thread.setDaemon(true);
    return thread;
  }

  private Runnable safely(Runnable task) {
    return () -> {
      try {
        task.run();
      } catch (RuntimeException e) {
        if (running) {
          log.warn("The check of the Git sources failed; retrying", e);
        }
      }
    };
  }

  @Override
  public void stop() {
    running = false;
    timer.shutdownNow();
    threads.shutdownNow();
  }

  @Override
  public boolean isRunning() {
    return running;
  }
}
