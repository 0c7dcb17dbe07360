package org.sitaf.server.access.session;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import org.sitaf.server.access.Backoff;
import org.sitaf.server.audit.Audit;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.network.Addresses;
import org.springframework.stereotype.Component;

/**
 * Limits attempts to sign in by growing delays per (name, address), per address and per name. The
 * delays per address and per name do not apply to users who signed in from the address before, so
 * that others, such as users behind the same proxy, cannot lock them out.
 */
@Component
class SignInLimit {
  private static final Duration KNOWN_FOR = Duration.ofDays(30);
  private static final int MAX_NAME = 100;

  private final Backoff perNameAndAddress =
      new Backoff(5, Duration.ofSeconds(10), Duration.ofMinutes(5));
  private final Backoff perAddress = new Backoff(30, Duration.ofSeconds(1), Duration.ofMinutes(1));
  private final Backoff perName = new Backoff(20, Duration.ofSeconds(1), Duration.ofMinutes(1));

  private final Audit audit;
  private final Clock clock;

  SignInLimit(Audit audit, Clock clock) {
    this.audit = audit;
    this.clock = clock;
  }

  /**
   * Registers an attempt; {@link #succeeded} takes it back.
   *
   * @throws RequestException if the caller has to wait
   */
  void attempt(String address, String anyName) {
    Instant now = clock.instant();
    String name = cut(anyName);
    String from = Addresses.group(address);
    Duration wait = perNameAndAddress.attempt(key(from, name), now);
    if (!wait.isZero()) {
      throw RequestException.tooManyAttempts(wait);
    }
    Duration here = perAddress.attempt(from, now);
    Duration anywhere = here.isZero() ? perName.attempt(name, now) : Duration.ZERO;
    if ((here.isZero() && anywhere.isZero())
        || audit.hasSignedIn(name, address, now.minus(KNOWN_FOR))) {
      return;
    }
    // A rejected attempt does not count.
    perNameAndAddress.takeBack(key(from, name));
    if (here.isZero()) {
      perAddress.takeBack(from);
    }
    throw RequestException.tooManyAttempts(here.isZero() ? anywhere : here);
  }

  /** Takes back a successful attempt. */
  void succeeded(String address, String name) {
    String from = Addresses.group(address);
    perNameAndAddress.forget(key(from, cut(name)));
    perAddress.takeBack(from);
    perName.takeBack(cut(name));
  }

  /** Bounds the memory that unauthenticated callers can use; no user has a longer name. */
  private static String cut(String name) {
    return name.length() <= MAX_NAME ? name : name.substring(0, MAX_NAME);
  }

  private static String key(String from, String name) {
    return from + ' ' + name;
  }
}
