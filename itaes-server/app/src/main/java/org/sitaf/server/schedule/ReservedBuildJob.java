package org.sitaf.server.schedule;

import java.time.Duration;
import java.time.Instant;
import java.util.Date;
import org.quartz.DisallowConcurrentExecution;
import org.quartz.Job;
import org.quartz.JobDataMap;
import org.quartz.JobExecutionContext;
import org.quartz.JobExecutionException;
import org.quartz.JobKey;
import org.quartz.SchedulerException;
import org.quartz.Trigger;
import org.quartz.TriggerBuilder;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Requests the build of a fire time. If the request fails, it is retried by persistent triggers.
 * The class name is stored in Quartz's tables.
 */
@DisallowConcurrentExecution
class ReservedBuildJob implements Job {
  /** With delays of 1 s, 2 s, 4 s and so on, more than eight minutes in total. */
  private static final int MAX_ATTEMPTS = 10;

  private static final String FIRE_TIME = "fireTime";
  private static final String ATTEMPT = "attempt";

  private static final Logger log = LoggerFactory.getLogger(ReservedBuildJob.class);

  private final Schedules schedules;

  ReservedBuildJob(Schedules schedules) {
    this.schedules = schedules;
  }

  @Override
  public void execute(JobExecutionContext context) throws JobExecutionException {
    JobKey key = context.getJobDetail().getKey();
    JobDataMap data = context.getTrigger().getJobDataMap();
    Instant fireTime =
        data.containsKey(FIRE_TIME)
            ? Instant.parse(data.getString(FIRE_TIME))
            : context.getScheduledFireTime().toInstant();
    int attempt = data.containsKey(ATTEMPT) ? data.getIntFromString(ATTEMPT) : 1;
    try {
      schedules.fire(key.getName(), fireTime);
    } catch (RuntimeException e) {
      if (attempt < MAX_ATTEMPTS) {
        log.warn(
            "Schedule {}: requesting the build of {} failed; retrying", key.getName(), fireTime, e);
        retry(context, fireTime, attempt + 1);
      } else {
        schedules.giveUp(key.getName(), fireTime);
        throw new JobExecutionException(e);
      }
    }
  }

  private static void retry(JobExecutionContext context, Instant fireTime, int attempt)
      throws JobExecutionException {
    JobKey key = context.getJobDetail().getKey();
    Duration delay = Duration.ofSeconds(1L << (attempt - 2));
    Trigger trigger =
        TriggerBuilder.newTrigger()
            .forJob(key)
            .withIdentity(key.getName() + " " + fireTime + " " + attempt, "retries")
            .usingJobData(FIRE_TIME, fireTime.toString())
            .usingJobData(ATTEMPT, Integer.toString(attempt))
            .startAt(Date.from(Instant.now().plus(delay)))
            .build();
    try {
      context.getScheduler().scheduleJob(trigger);
    } catch (SchedulerException e) {
      // The database is unavailable. Quartz refires the job and waits for a connection.
      throw new JobExecutionException(e, true);
    }
  }
}
