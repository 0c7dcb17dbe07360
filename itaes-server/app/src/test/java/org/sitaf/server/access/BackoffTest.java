package org.sitaf.server.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.Test;

class BackoffTest {
  private static final Instant START = Instant.parse("2026-01-01T00:00:00Z");

  private final Backoff backoff = new Backoff(3, Duration.ofSeconds(1), Duration.ofSeconds(10));

  @Test
  void delaysDoubleUpToTheLongest() {
    Instant now = START;
    for (int i = 0; i < 3; i++) {
      assertThat(backoff.attempt("a", now)).isZero();
    }
    for (long expected : new long[] {1, 2, 4, 8, 10, 10}) {
      assertThat(backoff.attempt("a", now)).isEqualTo(Duration.ofSeconds(expected));
      now = now.plusSeconds(expected);
      assertThat(backoff.attempt("a", now)).isZero();
    }
    assertThat(backoff.attempt("b", now)).isZero();
  }

  @Test
  void earlyAttemptsDoNotIncreaseTheDelay() {
    for (int i = 0; i < 3; i++) {
      backoff.attempt("a", START);
    }
    for (int i = 0; i < 100; i++) {
      assertThat(backoff.attempt("a", START)).isEqualTo(Duration.ofSeconds(1));
    }
    assertThat(backoff.attempt("a", START.plusSeconds(1))).isZero();
  }

  @Test
  void successfulAttemptsAndOldFailuresDoNotCount() {
    for (int i = 0; i < 50; i++) {
      assertThat(backoff.attempt("a", START)).isZero();
      backoff.takeBack("a");
    }
    for (int i = 0; i < 3; i++) {
      backoff.attempt("a", START);
    }
    assertThat(backoff.attempt("a", START.plusSeconds(21))).isZero();
    assertThat(backoff.attempt("a", START.plusSeconds(21))).isZero();
  }

  @Test
  void memoryIsBoundedForManyKeys() {
    for (int i = 0; i < 50_000; i++) {
      assertThat(backoff.attempt("key " + i, START.plusMillis(i))).isZero();
    }
    assertThat(backoff.size()).isLessThan(20_000);
  }
}
