package org.sitaf.server.access.session;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import org.sitaf.server.access.Backoff;
import org.sitaf.server.access.Denial;
import org.sitaf.server.audit.Audit;
import org.sitaf.server.network.Addresses;
import org.springframework.stereotype.Component;

/**
 * How often somebody may try to sign in: with delays that grow for a name from one address, for all
 * names from an address, and for a name from anywhere. The latter two do not hold for those who
 * have signed in from there before: strangers cannot lock them out, nor can they whose proxy they
 * share.
 */
@Component
class SignInLimit {
  private static final Duration KNOWN_FOR = Duration.ofDays(30);
  private static final int LONGEST_NAME = 100;

  private final Backoff ofNameFromAddress =
      new Backoff(5, Duration.ofSeconds(10), Duration.ofMinutes(5));
  private final Backoff ofAddress = new Backoff(30, Duration.ofSeconds(1), Duration.ofMinutes(1));
  private final Backoff ofName = new Backoff(20, Duration.ofSeconds(1), Duration.ofMinutes(1));

  private final Audit audit;
  private final Clock clock;

  SignInLimit(Audit audit, Clock clock) {
    this.audit = audit;
    this.clock = clock;
  }

  /**
   * Notes an attempt; one that succeeds is taken back.
   *
   * @throws org.springframework.web.ErrorResponseException (429) when it comes too early
   */
  void attempt(String address, String anyName) {
    Instant now = clock.instant();
    String name = cut(anyName);
    String from = Addresses.group(address);
    Duration wait = ofNameFromAddress.attempt(key(from, name), now);
    if (!wait.isZero()) {
      throw Denial.tooOften(wait);
    }
    Duration here = ofAddress.attempt(from, now);
    Duration anywhere = here.isZero() ? ofName.attempt(name, now) : Duration.ZERO;
    if ((here.isZero() && anywhere.isZero())
        || audit.hasSignedIn(name, address, now.minus(KNOWN_FOR))) {
      return;
    }
    // What is refused has tried nothing.
    ofNameFromAddress.takeBack(key(from, name));
    if (here.isZero()) {
      ofAddress.takeBack(from);
    }
    throw Denial.tooOften(here.isZero() ? anywhere : here);
  }

  /** The attempt was a right one. */
  void succeeded(String address, String name) {
    String from = Addresses.group(address);
    ofNameFromAddress.forget(key(from, cut(name)));
    ofAddress.takeBack(from);
    ofName.takeBack(cut(name));
  }

  /** Nobody has a longer name, and what is remembered is strangers' to choose. */
  private static String cut(String name) {
    return name.length() <= LONGEST_NAME ? name : name.substring(0, LONGEST_NAME);
  }

  private static String key(String from, String name) {
    return from + ' ' + name;
  }
}
