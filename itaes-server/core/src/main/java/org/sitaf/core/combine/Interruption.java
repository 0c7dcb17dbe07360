package org.sitaf.core.combine;

import java.util.concurrent.CancellationException;

/**
 * Stops long computations when their thread is interrupted. Callers implement timeouts by
 * interrupting the thread.
 */
public final class Interruption {
  private Interruption() {}

  /**
   * Throws if the thread is interrupted. The interrupt status is kept.
   *
   * @throws CancellationException if the thread is interrupted
   */
  public static void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("the generation of test cases was interrupted");
    }
  }
}
