package org.sitaf.server.build;

/** State of a build or an attempt, in the order in which they are reached. */
public enum BuildState {
  /** Waiting for an agent. */
  QUEUED,
  /** Assigned to an agent, which has not reported a state yet. */
  LEASED,
  /** The agent downloads the files. */
  PREPARING,
  COMPILING,
  RUNNING,
  UPLOADING,
  /** A result was accepted. */
  DONE,
  /** There is no result. */
  FAILED,
  CANCELLED,
  /**
   * Only for attempts: the result was delivered after the attempt was abandoned, and does not
   * count.
   */
  SUPERSEDED;

  /** Whether it is assigned to an agent. */
  public boolean isActive() {
    return compareTo(LEASED) >= 0 && compareTo(UPLOADING) <= 0;
  }

  /** Whether this is a final state. */
  public boolean isOver() {
    return compareTo(DONE) >= 0;
  }
}
