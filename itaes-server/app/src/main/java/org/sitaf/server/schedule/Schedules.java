package org.sitaf.server.schedule;

import java.time.Clock;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.temporal.ChronoUnit;
import java.util.Date;
import java.util.UUID;
import org.quartz.JobBuilder;
import org.quartz.JobKey;
import org.quartz.Scheduler;
import org.quartz.SchedulerException;
import org.quartz.SimpleScheduleBuilder;
import org.quartz.TriggerBuilder;
import org.quartz.TriggerKey;
import org.sitaf.server.build.Builds;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.Reservation;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.suite.Suites;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Transactional;
import org.springframework.transaction.support.TransactionTemplate;

/** Reserved builds. Quartz keeps the time; its tables and ours change in one transaction. */
@Service
class Schedules {
  private static final Logger log = LoggerFactory.getLogger(Schedules.class);
  private static final String GROUP = "reserved-builds";

  private final ScheduleRepository schedules;
  private final Suites suites;
  private final Builds builds;
  private final Scheduler quartz;
  private final TransactionTemplate transaction;
  private final Clock clock;

  Schedules(
      ScheduleRepository schedules,
      Suites suites,
      Builds builds,
      Scheduler quartz,
      TransactionTemplate transaction,
      Clock clock) {
    this.schedules = schedules;
    this.suites = suites;
    this.builds = builds;
    this.quartz = quartz;
    this.transaction = transaction;
    this.clock = clock;
  }

  /** Reserves a build. A time that passes while the server is down counts when it is up again. */
  String reserve(String suiteId, OffsetDateTime at) {
    suites.origin(suiteId);
    if (!at.toInstant().isAfter(now())) {
      throw Refusal.malformed(
          "at: " + at + " is past; give a time to come, or request a build at once.");
    }
    String id = UUID.randomUUID().toString();
    transaction.executeWithoutResult(
        status -> {
          schedules.save(new Schedule(id, suiteId, at, now()));
          arm(id, at.toInstant());
        });
    wakeQuartz(id);
    return id;
  }

  private void arm(String id, Instant at) {
    try {
      quartz.scheduleJob(
          JobBuilder.newJob(ReservedBuildJob.class)
              .withIdentity(id, GROUP)
              .requestRecovery()
              .build(),
          TriggerBuilder.newTrigger()
              .withIdentity(id, GROUP)
              .startAt(Date.from(at))
              .withSchedule(
                  SimpleScheduleBuilder.simpleSchedule().withMisfireHandlingInstructionFireNow())
              .build());
    } catch (SchedulerException e) {
      throw new IllegalStateException("Quartz refused the reservation", e);
    }
  }

  /**
   * Quartz looked for new triggers before our transaction ended, saw none, and would look again
   * half a minute later. To resume a trigger that is not paused changes nothing, but has it look
   * now.
   */
  private void wakeQuartz(String id) {
    try {
      quartz.resumeTrigger(new TriggerKey(id, GROUP));
    } catch (SchedulerException e) {
      log.warn("Reservation {} may be up to 30 s late", id, e);
    }
  }

  /**
   * Requests the build of a reservation whose time has come; doing so again makes no second one.
   */
  void fire(String id, Instant fireTime) {
    Schedule schedule = schedules.findById(id).orElse(null);
    if (schedule == null) {
      return;
    }
    builds.requestReserved(
        schedule.suiteId(),
        BuildOptions.DEFAULT,
        new Reservation(id, fireTime.truncatedTo(ChronoUnit.MICROS)));
    transaction.executeWithoutResult(
        status -> schedules.findById(id).ifPresent(s -> s.markFired(now())));
  }

  Page<Schedule> list(Pageable page) {
    return schedules.findAll(page);
  }

  Schedule find(String id) {
    return schedules.findById(id).orElseThrow(() -> Refusal.notFound("schedule", id));
  }

  @Transactional
  public void delete(String id) {
    schedules.delete(find(id));
    try {
      quartz.deleteJob(new JobKey(id, GROUP));
    } catch (SchedulerException e) {
      throw new IllegalStateException("Quartz did not let go of the reservation", e);
    }
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
