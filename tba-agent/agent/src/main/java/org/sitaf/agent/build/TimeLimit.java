package org.sitaf.agent.build;

import java.time.Duration;
import org.sitaf.core.activity.ActivityProfile.Limits;

/**
 * What a build may take: as long as its cases may take by their own limits, and no longer than the
 * administrator of the machine grants.
 *
 * @param cases for all cases together; the rest is not executed then
 * @param all for the build as a whole; it is cancelled then
 */
record TimeLimit(Duration cases, Duration all) {
  /** What a process may need for its start, as each case may need one. */
  private static final Duration START = Duration.ofSeconds(10);

  /** For starts that fail, and simulators that are started again. */
  private static final Duration SPARE = Duration.ofMinutes(5);

  /** Preparing, compiling, and what comes after the cases. */
  private static final Duration REST = Duration.ofMinutes(30);

  static TimeLimit of(int cases, Limits limits, Duration atMost) {
    Duration own = limits.caseWall().plus(START).multipliedBy(cases).plus(SPARE);
    Duration granted = own.compareTo(atMost) < 0 ? own : atMost;
    return new TimeLimit(granted, granted.plus(REST));
  }
}
