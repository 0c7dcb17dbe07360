package org.sitaf.server.build;

/** Who speaks holds an attempt that is over, or never was: what it says changes nothing. */
public final class OutdatedAttemptException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Of such an attempt. */
  public OutdatedAttemptException(AttemptKey key, String why) {
    super("attempt " + key.no() + " of build " + key.buildId() + " " + why);
  }
}
