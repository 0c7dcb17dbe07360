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

/** Long-polling requests that wait for a change of a build. */
@Component
class BuildWaiters {
  private static final Logger log = LoggerFactory.getLogger(BuildWaiters.class);
  private static final long SHARED_INTERVAL_MS = 500;

  private final Map<String, Set<Runnable>> waiters = new ConcurrentHashMap<>();

  /** A separate thread, because the event's thread still holds its database connection. */
  private final ScheduledExecutorService thread = DaemonTimer.named("build-waiters");

  BuildWaiters(Database database) {
    if (database.isShared()) {
      // Changes of other servers cause no events here.
      var unused =
          thread.scheduleWithFixedDelay(
              this::runAll, SHARED_INTERVAL_MS, SHARED_INTERVAL_MS, TimeUnit.MILLISECONDS);
    }
  }

  private void runAll() {
    for (Set<Runnable> actions : waiters.values()) {
      for (Runnable action : actions) {
        try {
          action.run();
        } catch (RuntimeException e) {
          log.warn("Check of a waiting request failed", e);
        }
      }
    }
  }

  /** Runs the action after each change of the build until it is removed. */
  void add(String buildId, Runnable action) {
    waiters.compute(
        buildId,
        (id, existing) -> {
          Set<Runnable> actions = existing == null ? ConcurrentHashMap.newKeySet() : existing;
          actions.add(action);
          return actions;
        });
  }

  void remove(String buildId, Runnable action) {
    waiters.computeIfPresent(
        buildId,
        (id, actions) -> {
          actions.remove(action);
          return actions.isEmpty() ? null : actions;
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
