package org.sitaf.server.schedule;

import java.time.Instant;
import java.time.ZoneId;
import java.util.Date;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.quartz.Calendar;
import org.quartz.JobBuilder;
import org.quartz.JobKey;
import org.quartz.JobPersistenceException;
import org.quartz.Scheduler;
import org.quartz.SchedulerException;
import org.quartz.Trigger;
import org.quartz.TriggerBuilder;
import org.quartz.TriggerKey;
import org.quartz.TriggerUtils;
import org.quartz.spi.OperableTrigger;
import org.sitaf.server.schedule.timing.ExcludedDays;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.stereotype.Component;

/** Schedules triggers in Quartz, within the transaction of the caller. */
@Component
class BuildScheduler {
  private static final Logger log = LoggerFactory.getLogger(BuildScheduler.class);

  /** Group of all jobs and triggers; stored in the database. */
  private static final String GROUP = "reserved-builds";

  private final Scheduler quartz;

  BuildScheduler(Scheduler quartz) {
    this.quartz = quartz;
  }

  private interface Action {
    void run() throws SchedulerException;
  }

  /**
   * Adds the trigger of a schedule.
   *
   * @return false if it would never fire
   */
  boolean add(String id, Timing timing, Misfire misfire, ExcludedDays excluded) {
    TriggerBuilder<? extends Trigger> trigger = timing.trigger(misfire).withIdentity(id, GROUP);
    boolean hasCalendar = !excluded.days().isEmpty() || !excluded.weekdays().isEmpty();
    Calendar calendar = excluded.toQuartz(timing.zone());
    if (hasCalendar) {
      trigger.modifiedByCalendar(id);
    }
    Trigger built = trigger.build();
    if (TriggerUtils.computeFireTimes((OperableTrigger) built, calendar, 1).isEmpty()) {
      return false;
    }
    run(
        () -> {
          if (hasCalendar) {
            quartz.addCalendar(id, calendar, true, true);
          }
          quartz.scheduleJob(
              JobBuilder.newJob(ReservedBuildJob.class)
                  .withIdentity(id, GROUP)
                  .requestRecovery()
                  .build(),
              built);
        });
    return true;
  }

  /** Replaces the excluded days of a schedule. */
  void exclude(String id, ExcludedDays excluded, ZoneId zone) {
    run(() -> quartz.addCalendar(id, excluded.toQuartz(zone), true, true));
  }

  void remove(String id) {
    run(
        () -> {
          quartz.deleteJob(new JobKey(id, GROUP));
          quartz.deleteCalendar(id);
        });
  }

  void pause(String id) {
    run(() -> quartz.pauseTrigger(new TriggerKey(id, GROUP)));
  }

  /** Resumes a schedule; its misfire policy applies to the times that it missed. */
  void resume(String id) {
    run(() -> quartz.resumeTrigger(new TriggerKey(id, GROUP)));
  }

  /**
   * Makes Quartz look for new triggers. Quartz was notified before our transaction was committed,
   * did not see the trigger, and would only look again after 30 s. Resuming a trigger that is not
   * paused does nothing but notify Quartz. Must be called after the transaction.
   */
  void wake(String id) {
    try {
      quartz.resumeTrigger(new TriggerKey(id, GROUP));
    } catch (SchedulerException e) {
      log.warn("Schedule {} may be up to 30 s late", id, e);
    }
  }

  /** The next fire times, at most {@code count}. */
  List<Instant> next(String id, int count) {
    try {
      Trigger trigger = trigger(id);
      if (trigger == null || trigger.getNextFireTime() == null) {
        return List.of();
      }
      Calendar calendar =
          trigger.getCalendarName() == null ? null : quartz.getCalendar(trigger.getCalendarName());
      Trigger fromNext = trigger.getTriggerBuilder().startAt(trigger.getNextFireTime()).build();
      return TriggerUtils.computeFireTimes((OperableTrigger) fromNext, calendar, count).stream()
          .map(Date::toInstant)
          .toList();
    } catch (SchedulerException e) {
      throw new IllegalStateException("Quartz cannot compute the fire times of schedule " + id, e);
    }
  }

  /**
   * The trigger of a schedule. Quartz reads it in two steps and throws if it fired for the last
   * time and was removed in between; a second look then finds that there is none.
   */
  private @Nullable Trigger trigger(String id) throws SchedulerException {
    TriggerKey key = new TriggerKey(id, GROUP);
    try {
      return quartz.getTrigger(key);
    } catch (JobPersistenceException e) {
      return quartz.getTrigger(key);
    }
  }

  /** The first fire times of a schedule that does not exist yet, at most {@code count}. */
  static List<Instant> preview(Timing timing, ExcludedDays excluded, int count) {
    Trigger trigger = timing.trigger(Misfire.ONCE).withIdentity("preview", GROUP).build();
    return TriggerUtils.computeFireTimes(
            (OperableTrigger) trigger, excluded.toQuartz(timing.zone()), count)
        .stream()
        .map(Date::toInstant)
        .toList();
  }

  Optional<Instant> next(String id) {
    return next(id, 1).stream().findFirst();
  }

  private static void run(Action action) {
    try {
      action.run();
    } catch (SchedulerException e) {
      throw new IllegalStateException("Quartz failed: " + e.getMessage(), e);
    }
  }
}
