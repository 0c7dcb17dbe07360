package org.sitaf.server.access.session;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.sitaf.server.access.Denial;
import org.springframework.stereotype.Component;

/**
 * How often somebody may try to sign in: a few times for a name from one address, more for all
 * names from it. A name alone is never locked, or strangers could lock people out.
 */
@Component
class SignInLimit {
  private static final int PER_NAME = 5;
  private static final int PER_ADDRESS = 30;
  private static final int MOST_KEPT = 10_000;
  private static final Duration WINDOW = Duration.ofMinutes(5);

  private final Map<String, Failures> failures = new ConcurrentHashMap<>();
  private final Clock clock;

  SignInLimit(Clock clock) {
    this.clock = clock;
  }

  private record Failures(int count, Instant since) {
    boolean isOver(Instant now) {
      return since.plus(WINDOW).isBefore(now);
    }
  }

  /**
   * Notes an attempt; one that succeeds is taken back.
   *
   * @throws org.springframework.web.ErrorResponseException (429) after too many
   */
  void attempt(String address, String name) {
    Instant now = clock.instant();
    if (failures.size() > MOST_KEPT) {
      failures.values().removeIf(known -> known.isOver(now));
    }
    count(address, PER_ADDRESS, now);
    count(key(address, name), PER_NAME, now);
  }

  /** The attempt was a right one. */
  void succeeded(String address, String name) {
    failures.remove(key(address, name));
    failures.computeIfPresent(
        address,
        (key, known) -> known.count() == 1 ? null : new Failures(known.count() - 1, known.since()));
  }

  private void count(String key, int most, Instant now) {
    Failures counted =
        failures.compute(
            key,
            (k, known) ->
                known == null || known.isOver(now)
                    ? new Failures(1, now)
                    : new Failures(Math.min(known.count() + 1, most + 1), known.since()));
    if (counted.count() > most) {
      throw Denial.tooOften(Duration.between(now, counted.since().plus(WINDOW)));
    }
  }

  private static String key(String address, String name) {
    return address + ' ' + name;
  }
}
