package org.sitaf.server.access;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * Delays that grow with each failure of somebody: twice as long each time, up to the longest.
 * Nobody is refused for good.
 */
public final class Backoff {
  private static final int MOST_KEPT = 10_000;
  private static final int MOST_DOUBLINGS = 20;

  private final int free;
  private final Duration first;
  private final Duration longest;
  private final Map<String, Failures> failures = new ConcurrentHashMap<>();

  /**
   * Delays of one kind.
   *
   * @param free how many failures delay nothing
   * @param first delay after them
   * @param longest delay; after twice as long without a failure all is forgotten
   */
  public Backoff(int free, Duration first, Duration longest) {
    this.free = free;
    this.first = first;
    this.longest = longest;
  }

  private record Failures(int count, Instant last, Duration refusedFor) {}

  /**
   * Notes an attempt, as a failure until it is known better.
   *
   * @return how long the one who tries has to wait, or zero: then the attempt counts
   */
  public Duration attempt(String who, Instant now) {
    forgetOld(now);
    Failures noted =
        failures.compute(
            who,
            (key, known) -> {
              if (known == null || isForgotten(known, now)) {
                return new Failures(1, now, Duration.ZERO);
              }
              Duration wait = Duration.between(now, known.last().plus(delay(known.count())));
              return wait.isNegative() || wait.isZero()
                  ? new Failures(known.count() + 1, now, Duration.ZERO)
                  : new Failures(known.count(), known.last(), wait);
            });
    return noted.refusedFor();
  }

  /** An attempt was a right one: it does not count. */
  public void takeBack(String who) {
    failures.computeIfPresent(
        who,
        (key, known) ->
            known.count() <= 1
                ? null
                : new Failures(known.count() - 1, known.last(), Duration.ZERO));
  }

  /** Nothing is held against anybody of that name any more. */
  public void forget(String who) {
    failures.remove(who);
  }

  /** How many are remembered. */
  int size() {
    return failures.size();
  }

  private Duration delay(int count) {
    if (count < free) {
      return Duration.ZERO;
    }
    Duration delay = first.multipliedBy(1L << Math.min(count - free, MOST_DOUBLINGS));
    return delay.compareTo(longest) > 0 ? longest : delay;
  }

  private boolean isForgotten(Failures known, Instant now) {
    return known.last().plus(longest.multipliedBy(2)).isBefore(now);
  }

  /** Where too many are known, those who came first go. */
  private void forgetOld(Instant now) {
    if (failures.size() <= MOST_KEPT) {
      return;
    }
    failures.values().removeIf(known -> isForgotten(known, now));
    @Nullable Instant oldest =
        failures.size() <= MOST_KEPT
            ? null
            : failures.values().stream().map(Failures::last).min(Instant::compareTo).orElse(null);
    if (oldest != null) {
      Instant limit = oldest.plus(Duration.between(oldest, now).dividedBy(2));
      failures.values().removeIf(known -> !known.last().isAfter(limit));
    }
  }
}
