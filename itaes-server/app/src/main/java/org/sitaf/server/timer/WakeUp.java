package org.sitaf.server.timer;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Runs a task at the earliest of the times that were requested. Not thread-safe: times are
 * requested by other tasks of the executor, whose only thread has ended this one then.
 */
public final class WakeUp {
  private final ScheduledExecutorService executor;
  private final Runnable task;
  private Instant next = Instant.MAX;
  private @Nullable Future<?> scheduled;

  public WakeUp(ScheduledExecutorService executor, Runnable task) {
    this.executor = executor;
    this.task = task;
  }

  /**
   * Runs the task at a time, unless it will run earlier. The timer of the executor is not the
   * clock: a task that ran shortly before its time can request the same time again.
   */
  public void at(Instant when, Instant now) {
    if (scheduled != null && !scheduled.isDone() && !when.isBefore(next)) {
      return;
    }
    next = when;
    // Rounded up, so that it does not run before the time.
    long delayMs = Math.max(0, Duration.between(now, when).toMillis()) + 1;
    scheduled = executor.schedule(task, delayMs, TimeUnit.MILLISECONDS);
  }
}
