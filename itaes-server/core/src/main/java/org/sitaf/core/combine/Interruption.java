package org.sitaf.core.combine;

import java.util.concurrent.CancellationException;

/** Long work ends when its thread is interrupted; a caller that has a clock sets the deadline. */
public final class Interruption {
  private Interruption() {}

  /**
   * Ends the work when its thread is interrupted; the thread stays interrupted.
   *
   * @throws CancellationException when it is
   */
  public static void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("the generation of test cases was interrupted");
    }
  }
}
