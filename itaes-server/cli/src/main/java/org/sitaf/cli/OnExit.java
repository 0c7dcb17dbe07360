package org.sitaf.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Lets a command that is stopped from outside (Ctrl-C, SIGTERM) end as it would by itself: asks it
 * to, and keeps the process until it has put things away.
 */
public final class OnExit implements AutoCloseable {
  private static final int LIMIT_S = 15;

  private final CountDownLatch putAway = new CountDownLatch(1);
  private final Thread hook;

  /**
   * From now until this is closed.
   *
   * @param stop makes the command end soon; called on another thread
   */
  public OnExit(Runnable stop) {
    hook =
        new Thread(
            () -> {
              stop.run();
              try {
                if (!putAway.await(LIMIT_S, TimeUnit.SECONDS)) {
                  System.err.println("sitaf: could not put everything away in " + LIMIT_S + " s");
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
    putAway.countDown();
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The process is ending, and the hook with it.
    }
  }
}
