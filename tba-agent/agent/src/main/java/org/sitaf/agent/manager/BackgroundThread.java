package org.sitaf.agent.manager;

import java.time.Duration;

/** A thread that works beside the builds, and keeps no process from its end. */
final class BackgroundThread {
  private final Thread thread;

  /** Not begun. */
  BackgroundThread(String name, Runnable work) {
    thread = new Thread(work, name);
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  /**
   * Leaves the work, which has been told to end, so much time for it, and interrupts it then. That
   * the caller is interrupted cuts the time short and is not forgotten.
   */
  void end(Duration atMost) {
    if (interruptAfter(atMost)) {
      Thread.currentThread().interrupt();
    }
  }

  /** Likewise, and does not return before the interrupted work has ended. */
  void endSurely(Duration atMost) {
    boolean interrupted = interruptAfter(atMost);
    try {
      thread.join();
    } catch (InterruptedException e) {
      interrupted = true;
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether the caller was interrupted meanwhile. */
  private boolean interruptAfter(Duration atMost) {
    boolean interrupted = false;
    try {
      thread.join(atMost.toMillis());
    } catch (InterruptedException e) {
      interrupted = true;
    }
    thread.interrupt();
    return interrupted;
  }
}
