package org.sitaf.agent.manager;

import java.time.Duration;

/** A daemon thread that works in the background of builds. */
final class BackgroundThread {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");

  private final Thread thread;

  /** Creates the thread without starting it. */
  BackgroundThread(String name, Runnable work) {
    thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.setUncaughtExceptionHandler(
        (ended, e) ->
            LOGGER.log(System.Logger.Level.ERROR, ended.getName() + " ended by a defect", e));
  }

  void start() {
    thread.start();
  }

  /**
   * Waits for the thread, which was asked to end, and interrupts it after the timeout. An interrupt
   * of the caller ends the wait and is restored.
   */
  void end(Duration atMost) {
    if (interruptAfter(atMost)) {
      Thread.currentThread().interrupt();
    }
  }

  /** Like above, and also waits for the interrupted thread to end. */
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

  /** Returns whether the caller was interrupted. */
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
