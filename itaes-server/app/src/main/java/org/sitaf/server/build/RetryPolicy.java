package org.sitaf.server.build;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.stereotype.Component;

/** Decides whether a build is retried after an attempt without a result. */
@Component
class RetryPolicy {
  private static final Duration MAX_DELAY = Duration.ofMinutes(1);

  private final ApplicationEventPublisher events;
  private final SitafSettings settings;
  private final Clock clock;

  RetryPolicy(ApplicationEventPublisher events, SitafSettings settings, Clock clock) {
    this.events = events;
    this.settings = settings;
    this.clock = clock;
  }

  /** RetryPolicy after a failure that an agent reported, with exponential backoff. */
  void afterFailure(Build build, BuildFailure failure) {
    retryOrFail(build, failure, delayAfter(build.countFailure()));
  }

  /** RetryPolicy without delay after an agent was lost. */
  void afterLoss(Build build, String why) {
    retryOrFail(
        build,
        new BuildFailure(BuildFailure.Category.INFRASTRUCTURE, why, List.of()),
        Duration.ZERO);
  }

  private void retryOrFail(Build build, BuildFailure failure, Duration delay) {
    boolean retry =
        failure.category() == BuildFailure.Category.INFRASTRUCTURE
            && build.attempt() < build.maxAttempts();
    if (retry) {
      build.queueAgain(failure.message(), now().plus(delay), now());
    } else {
      build.fail(failure, now());
    }
    events.publishEvent(BuildEvent.Changed.of(build));
  }

  private Duration delayAfter(int failuresBefore) {
    Duration doubled = settings.retryDelay().multipliedBy(1L << Math.min(failuresBefore, 20));
    return doubled.compareTo(MAX_DELAY) < 0 ? doubled : MAX_DELAY;
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
