package org.sitaf.agent.build;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Runs a build in a thread that can be abandoned: if it blocks on something that cannot be
 * interrupted, such as a failing disk, a cancelled build still ends.
 */
final class BuildThread {
  /** Time for a cancelled build to end its processes. */
  private static final Duration GRACE = Duration.ofSeconds(10);

  private final Cancellation cancellation;
  private final AtomicReference<@Nullable BuildOutcome> outcome = new AtomicReference<>();
  private final AtomicReference<@Nullable Throwable> failure = new AtomicReference<>();
  private final Thread thread;

  BuildThread(Cancellation cancellation, Supplier<BuildOutcome> work) {
    this.cancellation = cancellation;
    this.thread = new Thread(() -> work(work), "sitaf-build-work");
    thread.setDaemon(true);
  }

  private void work(Supplier<BuildOutcome> work) {
    try {
      outcome.set(work.get());
    } catch (RuntimeException | Error e) {
      failure.set(e);
    } finally {
      cancellation.workEnded();
    }
  }

  /**
   * Waits for the outcome.
   *
   * @param atMost timeout after which the build is cancelled
   */
  BuildOutcome run(Duration atMost) {
    thread.start();
    long end = System.nanoTime() + atMost.toNanos();
    boolean interrupted = false;
    try {
      while (!cancellation.isOver() && !cancellation.isRequested()) {
        long left = (end - System.nanoTime()) / 1_000_000;
        if (left <= 0) {
          cancellation.request("the build took longer than " + atMost.toMinutes() + " minutes");
        } else {
          cancellation.await(left);
        }
      }
    } catch (InterruptedException e) {
      interrupted = true;
      thread.interrupt();
    }
    interrupted |= joinWithin(GRACE);
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    if (failure.get() instanceof RuntimeException e) {
      throw e;
    }
    if (failure.get() instanceof Error e) {
      throw e;
    }
    BuildOutcome ended = outcome.get();
    return ended != null
        ? ended
        : new BuildOutcome.Cancelled(
            cancellation.reason().orElse("the agent's thread was interrupted"));
  }

  private boolean joinWithin(Duration atMost) {
    long end = System.nanoTime() + atMost.toNanos();
    boolean interrupted = false;
    for (long left = atMost.toMillis();
        thread.isAlive() && left > 0;
        left = (end - System.nanoTime()) / 1_000_000) {
      try {
        thread.join(left);
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    return interrupted;
  }
}
