package org.sitaf.server.build.rest;

import jakarta.annotation.PreDestroy;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.settings.Database;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.stereotype.Component;
import org.springframework.transaction.event.TransactionalEventListener;

/** Requests that wait for a change of a build. */
@Component
class BuildWaiters {
  private static final Logger log = LoggerFactory.getLogger(BuildWaiters.class);
  private static final long SHARED_LOOK_MS = 500;

  private final Map<String, Set<Runnable>> waiters = new ConcurrentHashMap<>();

  /** A thread of its own: who changed the build still holds its connection to the database. */
  private final ScheduledExecutorService thread = DaemonTimer.named("build-waiters");

  BuildWaiters(Database database) {
    if (database.isShared()) {
      // Nobody tells this server of what happens at another one.
      var unused =
          thread.scheduleWithFixedDelay(
              this::lookAll, SHARED_LOOK_MS, SHARED_LOOK_MS, TimeUnit.MILLISECONDS);
    }
  }

  private void lookAll() {
    for (Set<Runnable> actions : waiters.values()) {
      for (Runnable action : actions) {
        try {
          action.run();
        } catch (RuntimeException e) {
          log.warn("A request that waits for a change could not look", e);
        }
      }
    }
  }

  /** Has the action run, from then on, after each change of the build. */
  void add(String buildId, Runnable action) {
    waiters.compute(
        buildId,
        (id, present) -> {
          Set<Runnable> all = present == null ? ConcurrentHashMap.newKeySet() : present;
          all.add(action);
          return all;
        });
  }

  void remove(String buildId, Runnable action) {
    waiters.computeIfPresent(
        buildId,
        (id, present) -> {
          present.remove(action);
          return present.isEmpty() ? null : present;
        });
  }

  @PreDestroy
  void stop() {
    thread.shutdownNow();
  }

  @TransactionalEventListener
  void on(BuildEvent.Changed change) {
    waiters.getOrDefault(change.buildId(), Set.of()).forEach(thread::execute);
  }
}
