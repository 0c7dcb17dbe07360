package org.sitaf.server.error;

import java.time.Duration;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** A request that the server rejects, for a reason that the caller or an operator can fix. */
public final class RequestException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** The reason, which decides the HTTP and the gRPC status. */
  public enum Reason {
    /** The caller is not signed in, or its credentials are wrong. */
    UNAUTHENTICATED,
    /** The caller is signed in but not allowed to do this. */
    FORBIDDEN,
    /** The caller tried to sign in too often. */
    TOO_MANY_ATTEMPTS,
    /** The resource does not exist. */
    NOT_FOUND,
    /** The request itself is invalid. */
    MALFORMED,
    /** The resource is in a state that does not allow the request. */
    CONFLICT,
    /** The resource was changed after the caller read it. */
    OUTDATED,
    /** The request exceeds a limit of the server. */
    TOO_LARGE,
    /** The server's disk is full. */
    DISK_FULL,
    /** The caller's quota is exceeded. */
    QUOTA,
    /** The request body did not arrive in time. */
    TIMEOUT,
    /** The server is busy. */
    BUSY
  }

  private static final Duration RETRY_WHEN_BUSY = Duration.ofSeconds(2);
  private static final Duration RETRY_WHEN_DISK_FULL = Duration.ofMinutes(1);

  private final Reason reason;
  private final @Nullable Duration retryAfter;

  private RequestException(Reason reason, String message, @Nullable Duration retryAfter) {
    super(message);
    this.reason = reason;
    this.retryAfter = retryAfter;
  }

  private RequestException(Reason reason, String message) {
    this(reason, message, null);
  }

  public Reason reason() {
    return reason;
  }

  /** How long the caller should wait before it repeats the request. */
  public Optional<Duration> retryAfter() {
    return Optional.ofNullable(retryAfter);
  }

  public static RequestException unauthenticated(String message) {
    return new RequestException(Reason.UNAUTHENTICATED, message);
  }

  public static RequestException forbidden(String message) {
    return new RequestException(Reason.FORBIDDEN, message);
  }

  /**
   * Too many attempts to sign in.
   *
   * @param wait until the next attempt is allowed; rounded up to at least a second
   */
  public static RequestException tooManyAttempts(Duration wait) {
    long seconds = Math.max(1, wait.toSeconds());
    return new RequestException(
        Reason.TOO_MANY_ATTEMPTS,
        "Too many attempts to sign in; try again in " + seconds + " s.",
        Duration.ofSeconds(seconds));
  }

  public static RequestException notFound(String what, String id) {
    return new RequestException(Reason.NOT_FOUND, "There is no " + what + " '" + id + "'.");
  }

  /** The resource does not exist; the message says why it could be missing. */
  public static RequestException notFound(String message) {
    return new RequestException(Reason.NOT_FOUND, message);
  }

  /** The request is invalid; the message says which value is wrong and what is allowed. */
  public static RequestException malformed(String message) {
    return new RequestException(Reason.MALFORMED, message);
  }

  /** The state of the resource does not allow the request; the message says which state would. */
  public static RequestException conflict(String message) {
    return new RequestException(Reason.CONFLICT, message);
  }

  /** The version that the caller gave in {@code If-Match} is not the current one. */
  public static RequestException outdated(String what, long current) {
    return new RequestException(
        Reason.OUTDATED,
        "The "
            + what
            + " was changed in the meantime and is now at version "
            + current
            + "; reload it and repeat the change.");
  }

  /**
   * The server's disk is full or nearly full.
   *
   * @param what is rejected
   * @param why which disk, and how much space is left
   */
  public static RequestException diskFull(String what, String why) {
    return new RequestException(
        Reason.DISK_FULL,
        what + ": " + why + ". Free disk space, or ask the administrator; stored data can be read.",
        RETRY_WHEN_DISK_FULL);
  }

  public static RequestException tooLarge(String message) {
    return new RequestException(Reason.TOO_LARGE, message);
  }

  /** The caller's quota is exceeded; the message contains the numbers. */
  public static RequestException quota(String message) {
    return new RequestException(Reason.QUOTA, message);
  }

  public static RequestException timeout(String message) {
    return new RequestException(Reason.TIMEOUT, message);
  }

  /** The server is busy; the message says with what, and when to try again. */
  public static RequestException busy(String message) {
    return new RequestException(Reason.BUSY, message, RETRY_WHEN_BUSY);
  }
}
