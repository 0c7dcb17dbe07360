package org.sitaf.server.schedule.timing;

import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.util.Date;
import java.util.TimeZone;
import org.quartz.CalendarIntervalScheduleBuilder;
import org.quartz.CronScheduleBuilder;
import org.quartz.ScheduleBuilder;
import org.quartz.SimpleScheduleBuilder;
import org.quartz.Trigger;
import org.quartz.TriggerBuilder;
import org.sitaf.server.error.RequestException;

/** The fire times of a schedule. */
public sealed interface Timing {
  /** The time zone of the schedule's days. */
  ZoneId zone();

  /** Creates a trigger of Quartz without an identity. */
  TriggerBuilder<? extends Trigger> trigger(Misfire misfire);

  /** A single time. */
  record Reserved(OffsetDateTime at) implements Timing {
    @Override
    public ZoneId zone() {
      return at.getOffset();
    }

    @Override
    public TriggerBuilder<? extends Trigger> trigger(Misfire misfire) {
      SimpleScheduleBuilder once = SimpleScheduleBuilder.simpleSchedule();
      return startingAt(
          at.toInstant(),
          misfire == Misfire.SKIP
              ? once.withMisfireHandlingInstructionNextWithRemainingCount()
              : once.withMisfireHandlingInstructionIgnoreMisfires());
    }
  }

  /** At the times of a cron expression. */
  record Cron(String expression, ZoneId zone) implements Timing {
    public Cron {
      CronText.toQuartz(expression);
    }

    @Override
    public TriggerBuilder<? extends Trigger> trigger(Misfire misfire) {
      CronScheduleBuilder cron =
          CronScheduleBuilder.cronSchedule(CronText.toQuartz(expression))
              .inTimeZone(TimeZone.getTimeZone(zone));
      return TriggerBuilder.newTrigger()
          .withSchedule(
              switch (misfire) {
                case SKIP -> cron.withMisfireHandlingInstructionDoNothing();
                case ONCE -> cron.withMisfireHandlingInstructionFireAndProceed();
                case ALL -> cron.withMisfireHandlingInstructionIgnoreMisfires();
              });
    }
  }

  /**
   * At regular intervals.
   *
   * @param from the first time
   */
  record Interval(int minutes, Instant from, ZoneId zone) implements Timing {
    private static final int MAX_MINUTES = 60 * 24 * 366;

    public Interval {
      if (minutes < 1 || minutes > MAX_MINUTES) {
        throw RequestException.malformed("everyMinutes: must be 1 to " + MAX_MINUTES + ".");
      }
    }

    @Override
    public TriggerBuilder<? extends Trigger> trigger(Misfire misfire) {
      CalendarIntervalScheduleBuilder interval =
          CalendarIntervalScheduleBuilder.calendarIntervalSchedule()
              .withIntervalInMinutes(minutes)
              .inTimeZone(TimeZone.getTimeZone(zone));
      return startingAt(
          from,
          switch (misfire) {
            case SKIP -> interval.withMisfireHandlingInstructionDoNothing();
            case ONCE -> interval.withMisfireHandlingInstructionFireAndProceed();
            case ALL -> interval.withMisfireHandlingInstructionIgnoreMisfires();
          });
    }
  }

  private static TriggerBuilder<? extends Trigger> startingAt(
      Instant start, ScheduleBuilder<? extends Trigger> schedule) {
    return TriggerBuilder.newTrigger().startAt(Date.from(start)).withSchedule(schedule);
  }
}
