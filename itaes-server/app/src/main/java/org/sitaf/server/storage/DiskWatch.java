package org.sitaf.server.storage;

import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.boot.health.contributor.Health;
import org.springframework.boot.health.contributor.HealthIndicator;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Component;

/**
 * Says when a disk runs full and when there is room again: to the log, to the health of the server,
 * and to what has to go on then.
 */
@Component("disks")
class DiskWatch implements HealthIndicator {
  private static final Logger log = LoggerFactory.getLogger(DiskWatch.class);

  private final DiskSpace disk;
  private final ApplicationEventPublisher events;
  private State last = State.ROOM;

  DiskWatch(DiskSpace disk, ApplicationEventPublisher events) {
    this.disk = disk;
    this.events = events;
  }

  private enum State {
    ROOM,
    NO_NEW_WORK,
    NOTHING_WRITTEN
  }

  @Scheduled(fixedDelayString = "PT1S")
  synchronized void look() {
    Optional<String> nothing = disk.whyNothingIsWritten();
    Optional<String> noNewWork = disk.whyNoNewWork();
    State now =
        nothing.isPresent()
            ? State.NOTHING_WRITTEN
            : noNewWork.isPresent() ? State.NO_NEW_WORK : State.ROOM;
    if (now == last) {
      return;
    }
    State before = last;
    last = now;
    switch (now) {
      case NOTHING_WRITTEN -> log.error("Nothing is written any more: {}", nothing.orElse(""));
      case NO_NEW_WORK -> log.warn("No new work is taken: {}", noNewWork.orElse(""));
      case ROOM -> log.warn("There is room on the disk again: new work is taken");
    }
    if (now == State.ROOM || before == State.NOTHING_WRITTEN) {
      events.publishEvent(new RoomAgain());
    }
  }

  @Override
  public Health health() {
    Optional<String> nothing = disk.whyNothingIsWritten();
    if (nothing.isPresent()) {
      return Health.down().withDetail("reason", nothing.get()).build();
    }
    return disk.whyNoNewWork()
        .map(why -> Health.outOfService().withDetail("reason", why).build())
        .orElseGet(() -> Health.up().build());
  }
}
