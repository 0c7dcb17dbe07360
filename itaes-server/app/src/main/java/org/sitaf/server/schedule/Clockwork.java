package org.sitaf.server.schedule;

import java.time.Instant;
import java.time.ZoneId;
import java.util.Date;
import java.util.List;
import java.util.Optional;
import org.quartz.Calendar;
import org.quartz.JobBuilder;
import org.quartz.JobKey;
import org.quartz.Scheduler;
import org.quartz.SchedulerException;
import org.quartz.Trigger;
import org.quartz.TriggerBuilder;
import org.quartz.TriggerKey;
import org.quartz.TriggerUtils;
import org.quartz.spi.OperableTrigger;
import org.sitaf.server.schedule.timing.LeftOutDays;
import org.sitaf.server.schedule.timing.Misfire;
import org.sitaf.server.schedule.timing.Timing;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.stereotype.Component;

/** Quartz, which keeps the time. Its tables change in the transaction of the caller. */
@Component
class Clockwork {
  private static final Logger log = LoggerFactory.getLogger(Clockwork.class);

  /** The name that the first reservations were stored with. */
  private static final String GROUP = "reserved-builds";

  private final Scheduler quartz;

  Clockwork(Scheduler quartz) {
    this.quartz = quartz;
  }

  /** Something that Quartz does. */
  private interface Action {
    void run() throws SchedulerException;
  }

  /**
   * Has a schedule fire from now on.
   *
   * @return false when it would never fire
   */
  boolean arm(String id, Timing timing, Misfire misfire, LeftOutDays leftOut) {
    TriggerBuilder<? extends Trigger> trigger = timing.trigger(misfire).withIdentity(id, GROUP);
    boolean hasCalendar = !leftOut.days().isEmpty() || !leftOut.weekdays().isEmpty();
    Calendar calendar = leftOut.toQuartz(timing.zone());
    if (hasCalendar) {
      trigger.modifiedByCalendar(id);
    }
    Trigger made = trigger.build();
    if (TriggerUtils.computeFireTimes((OperableTrigger) made, calendar, 1).isEmpty()) {
      return false;
    }
    act(
        () -> {
          if (hasCalendar) {
            quartz.addCalendar(id, calendar, true, true);
          }
          quartz.scheduleJob(
              JobBuilder.newJob(ReservedBuildJob.class)
                  .withIdentity(id, GROUP)
                  .requestRecovery()
                  .build(),
              made);
        });
    return true;
  }

  /** The days that a schedule leaves out are others now. */
  void leaveOut(String id, LeftOutDays leftOut, ZoneId zone) {
    act(() -> quartz.addCalendar(id, leftOut.toQuartz(zone), true, true));
  }

  void disarm(String id) {
    act(
        () -> {
          quartz.deleteJob(new JobKey(id, GROUP));
          quartz.deleteCalendar(id);
        });
  }

  void pause(String id) {
    act(() -> quartz.pauseTrigger(new TriggerKey(id, GROUP)));
  }

  /** Goes on; what was missed meanwhile is dealt with as the schedule wants it. */
  void resume(String id) {
    act(() -> quartz.resumeTrigger(new TriggerKey(id, GROUP)));
  }

  /**
   * Quartz looked for new triggers before our transaction ended, saw none, and would look again
   * half a minute later. To resume a trigger that is not paused changes nothing, but has it look
   * now. To be called after the transaction.
   */
  void wake(String id) {
    try {
      quartz.resumeTrigger(new TriggerKey(id, GROUP));
    } catch (SchedulerException e) {
      log.warn("Schedule {} may be up to 30 s late", id, e);
    }
  }

  /** The next times, as many as asked for or as there are. */
  List<Instant> next(String id, int count) {
    try {
      Trigger trigger = quartz.getTrigger(new TriggerKey(id, GROUP));
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
      throw new IllegalStateException("Quartz does not say when schedule " + id + " fires", e);
    }
  }

  /** The first times of what is not armed, as many as asked for or as there are. */
  static List<Instant> times(Timing timing, LeftOutDays leftOut, int count) {
    Trigger trigger = timing.trigger(Misfire.ONCE).withIdentity("preview", GROUP).build();
    return TriggerUtils.computeFireTimes(
            (OperableTrigger) trigger, leftOut.toQuartz(timing.zone()), count)
        .stream()
        .map(Date::toInstant)
        .toList();
  }

  Optional<Instant> next(String id) {
    return next(id, 1).stream().findFirst();
  }

  private static void act(Action action) {
    try {
      action.run();
    } catch (SchedulerException e) {
      throw new IllegalStateException("Quartz refused: " + e.getMessage(), e);
    }
  }
}
