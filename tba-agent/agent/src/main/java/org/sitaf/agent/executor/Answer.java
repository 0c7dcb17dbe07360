package org.sitaf.agent.executor;

import java.time.Duration;

/** Collects the output of a process until it pauses; limited in size. */
final class Answer {
  private static final int MAX_LENGTH = 256 * 1024;
  private static final Duration MAX_WAIT = Duration.ofSeconds(2);
  private static final Duration QUIET = Duration.ofMillis(200);

  private final StringBuilder text = new StringBuilder();
  private boolean listening;
  private long lastOutput;

  synchronized void begin() {
    listening = true;
    lastOutput = System.nanoTime();
  }

  synchronized void add(String more) {
    if (listening) {
      text.append(more, 0, Math.min(more.length(), MAX_LENGTH - text.length()));
      lastOutput = System.nanoTime();
      notifyAll();
    }
  }

  /** The output since {@link #listen}. */
  synchronized String untilQuiet() throws InterruptedException {
    long end = System.nanoTime() + MAX_WAIT.toNanos();
    while (System.nanoTime() < end) {
      long quiet = System.nanoTime() - lastOutput;
      if (!text.isEmpty() && quiet >= QUIET.toNanos()) {
        break;
      }
      wait(Math.max(1, (QUIET.toNanos() - Math.min(quiet, QUIET.toNanos())) / 1_000_000));
    }
    listening = false;
    return text.toString();
  }
}
