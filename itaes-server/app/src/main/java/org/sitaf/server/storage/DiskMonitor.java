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
 * Reports full disks in the log and the health endpoint, and publishes an event when there is space
 * again.
 */
@Component("disks")
class DiskMonitor implements HealthIndicator {
  private static final Logger log = LoggerFactory.getLogger(DiskMonitor.class);

  private final DiskSpace disk;
  private final DiskReserve reserve;
  private final ApplicationEventPublisher events;
  private State last = State.OK;

  DiskMonitor(DiskSpace disk, DiskReserve reserve, ApplicationEventPublisher events) {
    this.disk = disk;
    this.reserve = reserve;
    this.events = events;
  }

  private enum State {
    OK,
    NO_NEW_WORK,
    READ_ONLY
  }

  @Scheduled(fixedDelayString = "PT1S")
  synchronized void check() {
    reserve.refill();
    Optional<String> readOnly = disk.whyNothingIsWritten();
    Optional<String> noNewWork = disk.whyNoNewWork();
    State now =
        readOnly.isPresent()
            ? State.READ_ONLY
            : noNewWork.isPresent() ? State.NO_NEW_WORK : State.OK;
    if (now == last) {
      return;
    }
    State before = last;
    last = now;
    switch (now) {
      case READ_ONLY -> log.error("Disk full, the server is read-only: {}", readOnly.orElse(""));
      case NO_NEW_WORK ->
          log.warn("Disk nearly full, the server accepts no new work: {}", noNewWork.orElse(""));
      case OK -> log.warn("There is enough disk space again, the server accepts new work");
    }
    if (now == State.OK || before == State.READ_ONLY) {
      events.publishEvent(new DiskSpaceRecovered());
    }
  }

  @Override
  public Health health() {
    Optional<String> readOnly = disk.whyNothingIsWritten();
    if (readOnly.isPresent()) {
      return Health.down().withDetail("reason", readOnly.get()).build();
    }
    return disk.whyNoNewWork()
        .map(why -> Health.outOfService().withDetail("reason", why).build())
        .orElseGet(() -> Health.up().build());
  }
}
