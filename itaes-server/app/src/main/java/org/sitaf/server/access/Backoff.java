package org.sitaf.server.access;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/** Exponential backoff for failed attempts, per key. A key is never blocked permanently. */
public final class Backoff {
  private static final int MAX_KEYS = 10_000;
  private static final int MAX_DOUBLINGS = 20;

  private final int free;
  private final Duration first;
  private final Duration longest;
  private final Map<String, Failures> failures = new ConcurrentHashMap<>();

  /**
   * Creates a backoff.
   *
   * @param free number of failures without a delay
   * @param first delay after these failures; it doubles with each further failure
   * @param longest maximum delay; a key without a failure for twice as long is removed
   */
  public Backoff(int free, Duration first, Duration longest) {
    this.free = free;
    this.first = first;
    this.longest = longest;
  }

  private record Failures(int count, Instant last, Duration retryAfter) {}

  /**
   * Registers an attempt. It counts as a failure until {@link #takeBack} or {@link #forget} is
   * called.
   *
   * @return how long the caller has to wait; zero when the attempt is allowed
   */
  public Duration attempt(String key, Instant now) {
    evict(now);
    Failures noted =
        failures.compute(
            key,
            (k, known) -> {
              if (known == null || isForgotten(known, now)) {
                return new Failures(1, now, Duration.ZERO);
              }
              Duration wait = Duration.between(now, known.last().plus(delay(known.count())));
              return wait.isNegative() || wait.isZero()
                  ? new Failures(known.count() + 1, now, Duration.ZERO)
                  : new Failures(known.count(), known.last(), wait);
            });
    return noted.retryAfter();
  }

  /** The attempt succeeded and does not count as a failure. */
  public void takeBack(String key) {
    failures.computeIfPresent(
        key,
        (k, known) ->
            known.count() <= 1
                ? null
                : new Failures(known.count() - 1, known.last(), Duration.ZERO));
  }

  /** Removes all failures of a key. */
  public void forget(String key) {
    failures.remove(key);
  }

  /** The number of keys with failures. */
  int size() {
    return failures.size();
  }

  private Duration delay(int count) {
    if (count < free) {
      return Duration.ZERO;
    }
    Duration delay = first.multipliedBy(1L << Math.min(count - free, MAX_DOUBLINGS));
    return delay.compareTo(longest) > 0 ? longest : delay;
  }

  private boolean isForgotten(Failures known, Instant now) {
    return known.last().plus(longest.multipliedBy(2)).isBefore(now);
  }

  /** Removes the oldest keys when there are more than {@link #MAX_KEYS}. */
  private void evict(Instant now) {
    if (failures.size() <= MAX_KEYS) {
      return;
    }
    failures.values().removeIf(known -> isForgotten(known, now));
    @Nullable Instant oldest =
        failures.size() <= MAX_KEYS
            ? null
            : failures.values().stream().map(Failures::last).min(Instant::compareTo).orElse(null);
    if (oldest != null) {
      Instant limit = oldest.plus(Duration.between(oldest, now).dividedBy(2));
      failures.values().removeIf(known -> !known.last().isAfter(limit));
    }
  }
}
