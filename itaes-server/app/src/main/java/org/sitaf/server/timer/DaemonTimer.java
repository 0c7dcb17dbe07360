package org.sitaf.server.timer;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;

/** One thread that does things at their time, one after the other. */
public final class DaemonTimer {
  private DaemonTimer() {}

  /**
   * Begins to wait for tasks; never keeps the process from its end.
   *
   * @param name of its thread
   */
  public static ScheduledExecutorService named(String name) {
    return Executors.newSingleThreadScheduledExecutor(
        task -> {
          Thread made = new Thread(task, name);
          made.setDaemon(true);
          return made;
        });
  }
}
