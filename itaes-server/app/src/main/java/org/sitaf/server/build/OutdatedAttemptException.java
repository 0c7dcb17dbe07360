package org.sitaf.server.build;

/** The caller's attempt has ended or does not exist; the request changes nothing. */
public final class OutdatedAttemptException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public OutdatedAttemptException(AttemptKey key, String why) {
    super("attempt " + key.no() + " of build " + key.buildId() + " " + why);
  }
}
