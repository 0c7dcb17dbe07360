package org.sitaf.runtime.simulation;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * Renews a session's lease in the background, so that a long call of the component does not end it.
 */
final class Lease implements AutoCloseable {
  private static final Duration SHORTEST = Duration.ofMillis(100);

  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "sitaf-lease");
            thread.setDaemon(true);
            return thread;
          });

  /** Renews three times in each length; two renewals may fail before the lease ends. */
  Lease(Duration length, Runnable renewal) {
    long period = Math.max(SHORTEST.toMillis(), length.toMillis() / 3);
    clock.scheduleWithFixedDelay(
        () -> {
          try {
            renewal.run();
          } catch (RuntimeException e) {
            // The next call of the test driver meets the same trouble, and tells it where it
            // matters.
          }
        },
        period,
        period,
        TimeUnit.MILLISECONDS);
  }

  @Override
  public void close() {
    clock.shutdownNow();
  }
}
