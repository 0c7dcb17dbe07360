package org.sitaf.server.git.commit;

import org.quartz.Job;
import org.quartz.JobExecutionContext;

/** Asks for the fetch of a source. The class name is stored in Quartz's tables. */
class PollJob implements Job {
  private final Fetches fetches;

  PollJob(Fetches fetches) {
    this.fetches = fetches;
  }

  @Override
  public void execute(JobExecutionContext context) {
    fetches.request(context.getJobDetail().getKey().getName());
  }
}
