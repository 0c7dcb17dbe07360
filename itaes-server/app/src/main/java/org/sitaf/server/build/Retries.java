package org.sitaf.server.build;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.stereotype.Component;

/** What becomes of a build after an attempt that brought no result: another, or its end. */
@Component
class Retries {
  private static final Duration LONGEST_PAUSE = Duration.ofMinutes(1);

  private final ApplicationEventPublisher events;
  private final SitafSettings settings;
  private final Clock clock;

  Retries(ApplicationEventPublisher events, SitafSettings settings, Clock clock) {
    this.events = events;
    this.settings = settings;
    this.clock = clock;
  }

  /** A failure that an agent reports may last: the build waits the longer, the more there were. */
  void afterFailure(Build build, BuildFailure failure) {
    tryAgain(build, failure, pauseAfter(build.noteFailure()));
  }

  /** Of an agent that is lost, nothing says that the next one will be. */
  void afterLoss(Build build, String why) {
    tryAgain(
        build,
        new BuildFailure(BuildFailure.Category.INFRASTRUCTURE, why, List.of()),
        Duration.ZERO);
  }

  private void tryAgain(Build build, BuildFailure failure, Duration pause) {
    boolean again =
        failure.category() == BuildFailure.Category.INFRASTRUCTURE
            && build.attempt() < build.maxAttempts();
    if (again) {
      build.queueAgain(failure.message(), now().plus(pause), now());
    } else {
      build.fail(failure, now());
    }
    events.publishEvent(BuildEvent.Changed.of(build));
  }

  private Duration pauseAfter(int failuresBefore) {
    Duration doubled = settings.retryDelay().multipliedBy(1L << Math.min(failuresBefore, 20));
    return doubled.compareTo(LONGEST_PAUSE) < 0 ? doubled : LONGEST_PAUSE;
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
