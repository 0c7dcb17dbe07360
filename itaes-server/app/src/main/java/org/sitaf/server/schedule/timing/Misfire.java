package org.sitaf.server.schedule.timing;

/**
 * The policy for fire times that were missed while no server was running or the schedule was
 * paused.
 */
public enum Misfire {
  /** No build. */
  SKIP,
  /** One build for all missed times. */
  ONCE,
  /** One build for each missed time. */
  ALL
}
