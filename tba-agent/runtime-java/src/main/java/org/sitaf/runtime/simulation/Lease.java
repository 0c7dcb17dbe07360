package org.sitaf.runtime.simulation;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/**
 * Renews the lease of a session in the background, so that it does not expire during a long call of
 * the component.
 */
final class Lease implements AutoCloseable {
  private static final Duration SHORTEST = Duration.ofMillis(100);

  private final ScheduledExecutorService scheduler =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "sitaf-lease");
            thread.setDaemon(true);
            return thread;
          });

  /** Renews three times per lease, so that two renewals may fail before it expires. */
  Lease(Duration length, Runnable renewal) {
    long period = Math.max(SHORTEST.toMillis(), length.toMillis() / 3);
    scheduler.scheduleWithFixedDelay(
        () -> {
          try {
            renewal.run();
          } catch (RuntimeException e) {
            // The next call of the test driver fails in the same way and reports the failure.
          }
        },
        period,
        period,
        TimeUnit.MILLISECONDS);
  }

  @Override
  public void close() {
    scheduler.shutdownNow();
  }
}
