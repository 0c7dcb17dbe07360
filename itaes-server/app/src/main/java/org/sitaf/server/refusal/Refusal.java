package org.sitaf.server.refusal;

/** The server does not do what it was asked for, and the one who asked can mend it. */
public final class Refusal extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Why. */
  public enum Reason {
    /** No such thing. */
    NOT_FOUND,
    /** The request itself is wrong. */
    MALFORMED,
    /** The state of the thing does not allow it. */
    CONFLICT,
    /** The thing was changed in the meantime. */
    OUTDATED,
    /** More than the server takes. */
    TOO_LARGE,
    /** The server's disk is full. */
    NO_ROOM,
    /** What the caller may store is used up. */
    QUOTA,
    /** The request took too long to arrive. */
    TOO_SLOW,
    /** The server has enough to do at present. */
    BUSY
  }

  private static final int SOON_S = 2;

  private final Reason reason;

  private Refusal(Reason reason, String message) {
    super(message);
    this.reason = reason;
  }

  /** After how many seconds a caller who was refused for {@link Reason#BUSY} tries again. */
  public static int retryAfterSeconds() {
    return SOON_S;
  }

  /** Which kind of refusal. */
  public Reason reason() {
    return reason;
  }

  /** There is no such thing. */
  public static Refusal notFound(String what, String id) {
    return new Refusal(Reason.NOT_FOUND, "There is no " + what + " '" + id + "'.");
  }

  /** The request contradicts its description; the message says what was expected. */
  public static Refusal malformed(String message) {
    return new Refusal(Reason.MALFORMED, message);
  }

  /** Its state does not allow it; the message says which would. */
  public static Refusal conflict(String message) {
    return new Refusal(Reason.CONFLICT, message);
  }

  /** Somebody changed it since it was read. */
  public static Refusal outdated(String what, long current) {
    return new Refusal(
        Reason.OUTDATED,
        "The "
            + what
            + " was changed meanwhile and is at version "
            + current
            + "; read it again and repeat the change.");
  }

  /**
   * The server's disk is full, or nearly so.
   *
   * @param what is not done
   * @param why which disk, and how much is left
   */
  public static Refusal noRoom(String what, String why) {
    return new Refusal(
        Reason.NO_ROOM,
        what
            + ": "
            + why
            + ". Make room on it, or ask whoever runs this server; what is stored can be read.");
  }

  /** More than the limit. */
  public static Refusal tooLarge(String message) {
    return new Refusal(Reason.TOO_LARGE, message);
  }

  /** The caller's quota does not allow it; the message holds the numbers. */
  public static Refusal quota(String message) {
    return new Refusal(Reason.QUOTA, message);
  }

  /** The body of a request did not arrive in time. */
  public static Refusal tooSlow(String message) {
    return new Refusal(Reason.TOO_SLOW, message);
  }

  /** The server does as much of it as it can; the message says of what, and when to try again. */
  public static Refusal busy(String message) {
    return new Refusal(Reason.BUSY, message);
  }
}
