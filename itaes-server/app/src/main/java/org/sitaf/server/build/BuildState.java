package org.sitaf.server.build;

/** Where a build, or an attempt of it, is; later ones come later. */
public enum BuildState {
  /** Waits for an agent. */
  QUEUED,
  /** Given to an agent, which has not said anything about it yet. */
  LEASED,
  /** The agent fetches the files. */
  PREPARING,
  COMPILING,
  RUNNING,
  UPLOADING,
  /** The result is accepted. */
  DONE,
  /** There is no result. */
  FAILED,
  CANCELLED,
  /** Only of an attempt: its result came after it was given up, and counts nowhere. */
  SUPERSEDED;

  /** Whether an agent works on it. */
  public boolean isActive() {
    return compareTo(LEASED) >= 0 && compareTo(UPLOADING) <= 0;
  }

  /** Whether nothing more will happen to it. */
  public boolean isOver() {
    return compareTo(DONE) >= 0;
  }
}
