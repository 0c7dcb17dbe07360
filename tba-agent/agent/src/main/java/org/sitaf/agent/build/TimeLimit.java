package org.sitaf.agent.build;

import java.time.Duration;
import org.sitaf.core.activity.ActivityProfile.Limits;

/**
 * Time limits of a build: the sum of the limits of its cases, up to the limit of the administrator.
 *
 * @param cases for all cases together; the remaining cases are not executed
 * @param all for the whole build, which is then cancelled
 */
record TimeLimit(Duration cases, Duration all) {
  /** Time to start a process, which each case may need. */
  private static final Duration PROCESS_START = Duration.ofSeconds(10);

  /** Time for failed starts and restarts of the simulator. */
  private static final Duration RESTARTS = Duration.ofMinutes(5);

  /** Time to start the simulation, for compilation and the work after the cases. */
  private static final Duration OTHER_STAGES = Duration.ofMinutes(30);

  static TimeLimit of(int cases, Limits limits, Duration atMost) {
    Duration own = limits.caseWall().plus(PROCESS_START).multipliedBy(cases).plus(RESTARTS);
    Duration granted = own.compareTo(atMost) < 0 ? own : atMost;
    Duration preparation =
        limits.preparation().compareTo(atMost) < 0 ? limits.preparation() : atMost;
    return new TimeLimit(granted, granted.plus(preparation).plus(OTHER_STAGES));
  }
}
