package org.sitaf.server.schedule.timing;

/** What becomes of fire times that passed while no server was up, or the schedule was paused. */
public enum Misfire {
  /** Nothing: the next time to come counts. */
  SKIP,
  /** One build for all of them, now. */
  ONCE,
  /** One build for each of them. */
  ALL
}
