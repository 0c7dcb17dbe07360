package org.sitaf.agent.build;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Lets other threads cancel a build. The build's thread is interrupted only inside of {@link
 * #guard}, so that no interrupt affects later work of the thread.
 */
final class Cancellation {
  private @Nullable String reason;
  private @Nullable Thread worker;
  private boolean ended;

  /** The work of a build. */
  @FunctionalInterface
  interface Work {
    BuildOutcome run() throws InterruptedException;
  }

  synchronized void request(String why) {
    if (reason == null) {
      reason = why;
      if (worker != null) {
        worker.interrupt();
      }
      notifyAll();
    }
  }

  synchronized boolean isRequested() {
    return reason != null;
  }

  synchronized boolean isOver() {
    return ended;
  }

  synchronized Optional<String> reason() {
    return Optional.ofNullable(reason);
  }

  /** The work has ended; waiting threads continue. */
  synchronized void workEnded() {
    ended = true;
    notifyAll();
  }

  /** Waits for a request or the end of the work. */
  synchronized void await(long atMostMs) throws InterruptedException {
    if (reason == null && !ended) {
      wait(atMostMs);
    }
  }

  /**
   * Runs the work; if it is cancelled before or during that time, the outcome is {@link
   * BuildOutcome.Cancelled}.
   */
  BuildOutcome guard(Work work) {
    synchronized (this) {
      if (reason != null) {
        return new BuildOutcome.Cancelled(reason);
      }
      worker = Thread.currentThread();
    }
    @Nullable BuildOutcome outcome = null;
    boolean interruptedFromOutside = false;
    try {
      outcome = work.run();
    } catch (InterruptedException e) {
      interruptedFromOutside = true;
    }
    synchronized (this) {
      worker = null;
      if (reason != null) {
        // The failure was caused by our interrupt.
        Thread.interrupted();
        return outcome instanceof BuildOutcome.Completed
            ? outcome
            : new BuildOutcome.Cancelled(reason);
      }
    }
    if (interruptedFromOutside || outcome == null) {
      Thread.currentThread().interrupt();
      return new BuildOutcome.Cancelled("the agent's thread was interrupted");
    }
    return outcome;
  }
}
