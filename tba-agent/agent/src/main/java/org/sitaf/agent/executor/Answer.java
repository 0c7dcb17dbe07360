package org.sitaf.agent.executor;

import java.time.Duration;

/** What a process prints from a moment on, until it has nothing more to say. Bounded. */
final class Answer {
  private static final int MAX_LENGTH = 256 * 1024;
  private static final Duration LONGEST = Duration.ofSeconds(2);
  private static final Duration QUIET = Duration.ofMillis(200);

  private final StringBuilder text = new StringBuilder();
  private boolean listening;
  private long lastHeard;

  synchronized void begin() {
    listening = true;
    lastHeard = System.nanoTime();
  }

  synchronized void add(String more) {
    if (listening) {
      text.append(more, 0, Math.min(more.length(), MAX_LENGTH - text.length()));
      lastHeard = System.nanoTime();
      notifyAll();
    }
  }

  /** All that was said since the beginning. */
  synchronized String untilQuiet() throws InterruptedException {
    long end = System.nanoTime() + LONGEST.toNanos();
    while (System.nanoTime() < end) {
      long quiet = System.nanoTime() - lastHeard;
      if (!text.isEmpty() && quiet >= QUIET.toNanos()) {
        break;
      }
      wait(Math.max(1, (QUIET.toNanos() - Math.min(quiet, QUIET.toNanos())) / 1_000_000));
    }
    listening = false;
    return text.toString();
  }
}
