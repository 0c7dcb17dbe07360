package org.sitaf.agent.manager;

import java.time.Duration;
import java.util.concurrent.ThreadLocalRandom;

/**
 * How long to wait before the next try: doubling, with jitter, so that many agents do not come back
 * at the same moment. Not safe for several threads.
 */
final class Backoff {
  private static final long FIRST_MS = 200;
  private static final long LAST_MS = 15_000;

  private long nextMs = FIRST_MS;
  private long lastMs = LAST_MS;

  Duration next() {
    long ms = nextMs / 2 + ThreadLocalRandom.current().nextLong(nextMs / 2 + 1);
    nextMs = Math.min(lastMs, nextMs * 2);
    return Duration.ofMillis(ms);
  }

  /** No wait is longer than this from now on. */
  void atMost(Duration longest) {
    lastMs = Math.max(FIRST_MS, longest.toMillis());
    nextMs = Math.min(lastMs, nextMs);
  }

  void reset() {
    nextMs = FIRST_MS;
  }
}
