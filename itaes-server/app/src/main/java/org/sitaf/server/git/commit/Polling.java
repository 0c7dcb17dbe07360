package org.sitaf.server.git.commit;

import java.time.Duration;
import java.time.Instant;
import java.util.Date;
import java.util.concurrent.ThreadLocalRandom;
import org.quartz.JobBuilder;
import org.quartz.JobDetail;
import org.quartz.JobKey;
import org.quartz.Scheduler;
import org.quartz.SchedulerException;
import org.quartz.SimpleScheduleBuilder;
import org.quartz.SimpleTrigger;
import org.quartz.Trigger;
import org.quartz.TriggerBuilder;
import org.quartz.TriggerKey;
import org.springframework.stereotype.Component;

/**
 * Schedules the fetches of sources in Quartz. Each source begins at a random time of its interval,
 * so that sources that were created together do not ask a forge at the same moment.
 */
@Component
class Polling {
  private static final String GROUP = "git-sources";

  private final Scheduler quartz;

  Polling(Scheduler quartz) {
    this.quartz = quartz;
  }

  /** Sets the interval of a source; does nothing if it has this one. */
  void schedule(String sourceId, int intervalS) {
    TriggerKey key = new TriggerKey(sourceId, GROUP);
    try {
      Trigger existing = quartz.getTrigger(key);
      if (existing instanceof SimpleTrigger simple
          && simple.getRepeatInterval() == Duration.ofSeconds(intervalS).toMillis()) {
        return;
      }
      long phaseMs =
          ThreadLocalRandom.current().nextLong(1, Duration.ofSeconds(intervalS).toMillis());
      Trigger trigger =
          TriggerBuilder.newTrigger()
              .withIdentity(key)
              .forJob(new JobKey(sourceId, GROUP))
              .startAt(Date.from(Instant.now().plusMillis(phaseMs)))
              .withSchedule(
                  SimpleScheduleBuilder.repeatSecondlyForever(intervalS)
                      .withMisfireHandlingInstructionNextWithRemainingCount())
              .build();
      if (existing == null) {
        JobDetail job =
            JobBuilder.newJob(PollJob.class).withIdentity(sourceId, GROUP).storeDurably().build();
        quartz.addJob(job, true);
        quartz.scheduleJob(trigger);
      } else {
        quartz.rescheduleJob(key, trigger);
      }
    } catch (SchedulerException e) {
      throw new IllegalStateException("Quartz failed: " + e.getMessage(), e);
    }
  }

  void remove(String sourceId) {
    try {
      quartz.deleteJob(new JobKey(sourceId, GROUP));
    } catch (SchedulerException e) {
      throw new IllegalStateException("Quartz failed: " + e.getMessage(), e);
    }
  }
}
