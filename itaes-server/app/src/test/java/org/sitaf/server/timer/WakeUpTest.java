package org.sitaf.server.timer;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class WakeUpTest {
  private static final Instant NOW = Instant.parse("2026-03-09T12:00:00Z");

  private final ScheduledExecutorService executor = DaemonTimer.named("test");
  private final Semaphore ran = new Semaphore(0);
  private final WakeUp wakeUp = new WakeUp(executor, ran::release);

  @AfterEach
  void stop() {
    executor.shutdownNow();
  }

  @Test
  void aTimeThatTheClockHasNotReachedCanBeRequestedAgain() throws Exception {
    Instant when = NOW.plusMillis(20);
    wakeUp.at(when, NOW);
    assertThat(ran.tryAcquire(1, TimeUnit.MINUTES)).isTrue();
    // The clock is slower than the timer. On the thread of the executor, where the task has ended.
    executor.submit(() -> wakeUp.at(when, NOW.plusMillis(15))).get(1, TimeUnit.MINUTES);
    assertThat(ran.tryAcquire(1, TimeUnit.MINUTES)).isTrue();
  }

  @Test
  void anEarlierTimeReplacesALaterOne() throws InterruptedException {
    wakeUp.at(NOW.plusSeconds(3600), NOW);
    wakeUp.at(NOW.plusMillis(10), NOW);
    assertThat(ran.tryAcquire(1, TimeUnit.MINUTES)).isTrue();
  }

  @Test
  void aLaterTimeIsNotScheduledBesideAnEarlierOne() throws InterruptedException {
    wakeUp.at(NOW.plusMillis(300), NOW);
    wakeUp.at(NOW.plusMillis(350), NOW);
    assertThat(ran.tryAcquire(1, TimeUnit.MINUTES)).isTrue();
    assertThat(ran.tryAcquire(500, TimeUnit.MILLISECONDS)).isFalse();
  }
}
