package org.sitaf.server.build.rest;

import jakarta.annotation.PreDestroy;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.sitaf.server.build.BuildEvent;
import org.springframework.stereotype.Component;
import org.springframework.transaction.event.TransactionalEventListener;

/** Requests that wait for a change of a build. */
@Component
class BuildWaiters {
  private final Map<String, Set<Runnable>> waiters = new ConcurrentHashMap<>();

  /** A thread of its own: who changed the build still holds its connection to the database. */
  private final ExecutorService thread =
      Executors.newSingleThreadExecutor(
          task -> {
            Thread made = new Thread(task, "build-waiters");
            made.setDaemon(true);
            return made;
          });

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
