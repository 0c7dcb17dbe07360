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
    /** The server has too much to do. */
    BUSY
  }

  private final Reason reason;

  private Refusal(Reason reason, String message) {
    super(message);
    this.reason = reason;
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

  /** The server has too much to do at present; the message says of what. */
  public static Refusal busy(String message) {
    return new Refusal(Reason.BUSY, message);
  }

  /** More than the limit. */
  public static Refusal tooLarge(String message) {
    return new Refusal(Reason.TOO_LARGE, message);
  }
}
