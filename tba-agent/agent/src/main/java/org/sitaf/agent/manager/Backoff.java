package org.sitaf.agent.manager;

import java.time.Duration;
import java.util.concurrent.ThreadLocalRandom;

/**
 * Exponential backoff with jitter, so that many agents do not retry at the same time. Not
 * thread-safe.
 */
final class Backoff {
  private static final long INITIAL_MS = 200;
  private static final long MAX_MS = 15_000;

  private long nextMs = INITIAL_MS;
  private long maxMs = MAX_MS;

  Duration next() {
    long ms = nextMs / 2 + ThreadLocalRandom.current().nextLong(nextMs / 2 + 1);
    nextMs = Math.min(maxMs, nextMs * 2);
    return Duration.ofMillis(ms);
  }

  /** Limits the following waits. */
  void atMost(Duration longest) {
    maxMs = Math.max(INITIAL_MS, longest.toMillis());
    nextMs = Math.min(maxMs, nextMs);
  }

  void reset() {
    nextMs = INITIAL_MS;
  }
}
