package org.sitaf.server.timer;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;

/** Creates executors for periodic tasks. */
public final class DaemonTimer {
  private DaemonTimer() {}

  /** Creates an executor with a single daemon thread of the given name. */
  public static ScheduledExecutorService named(String name) {
    return Executors.newSingleThreadScheduledExecutor(
        task -> {
          Thread thread = new Thread(task, name);
          thread.setDaemon(true);
          return thread;
        });
  }
}
