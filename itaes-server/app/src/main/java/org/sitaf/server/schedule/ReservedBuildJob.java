package org.sitaf.server.schedule;

import org.quartz.DisallowConcurrentExecution;
import org.quartz.Job;
import org.quartz.JobExecutionContext;
import org.quartz.JobExecutionException;

/** Inserts a build request, and nothing else: what happens to it is the business of others. */
@DisallowConcurrentExecution
class ReservedBuildJob implements Job {
  private final Schedules schedules;

  ReservedBuildJob(Schedules schedules) {
    this.schedules = schedules;
  }

  @Override
  public void execute(JobExecutionContext context) throws JobExecutionException {
    try {
      schedules.fire(
          context.getJobDetail().getKey().getName(), context.getScheduledFireTime().toInstant());
    } catch (RuntimeException e) {
      throw new JobExecutionException(e);
    }
  }
}
