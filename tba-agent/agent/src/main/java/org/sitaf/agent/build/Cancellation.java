package org.sitaf.agent.build;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Lets other threads end a build. The build's thread is interrupted only while it is inside {@link
 * #guard}, so that no interrupt reaches what the thread does afterwards.
 */
final class Cancellation {
  private @Nullable String reason;
  private @Nullable Thread worker;
  private boolean over;

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
    return over;
  }

  synchronized Optional<String> reason() {
    return Optional.ofNullable(reason);
  }

  /** The work is over; who waits for it may go on. */
  synchronized void workEnded() {
    over = true;
    notifyAll();
  }

  /** Waits for a request or for the end of the work. */
  synchronized void await(long atMostMs) throws InterruptedException {
    if (reason == null && !over) {
      wait(atMostMs);
    }
  }

  /**
   * Does the work; a cancellation before, during or because of an interrupt of it is the outcome
   * then.
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
        // The interrupt was ours; whatever failed because of it is not a failure of its own.
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
