package org.sitaf.cli.terminal;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Stops a command on Ctrl-C or SIGTERM: asks it to end, and delays the exit of the process until it
 * has cleaned up.
 */
public final class OnExit implements AutoCloseable {
  private static final int LIMIT_S = 15;

  private final CountDownLatch cleanedUp = new CountDownLatch(1);
  private final Thread hook;

  /**
   * Installs the hook until this is closed.
   *
   * @param stop asks the command to end; called in another thread
   */
  public OnExit(Runnable stop) {
    hook =
        new Thread(
            () -> {
              stop.run();
              try {
                if (!cleanedUp.await(LIMIT_S, TimeUnit.SECONDS)) {
                  System.err.println("sitaf: cleaning up took longer than " + LIMIT_S + " s");
                }
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "sitaf-exit");
    Runtime.getRuntime().addShutdownHook(hook);
  }

  @Override
  public void close() {
    cleanedUp.countDown();
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The process is already exiting.
    }
  }
}
