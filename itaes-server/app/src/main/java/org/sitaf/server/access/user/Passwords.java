package org.sitaf.server.access.user;

import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.refusal.Refusal;
import org.springframework.security.crypto.bcrypt.BCryptPasswordEncoder;
import org.springframework.stereotype.Component;

/** Hashes passwords by bcrypt, and makes random ones. */
@Component
class Passwords {
  private static final int STRENGTH = 12;
  private static final int SHORTEST = 12;

  /** What bcrypt takes into account, in bytes. */
  private static final int LONGEST = 72;

  /** Without what looks alike: people copy these by hand. */
  private static final String ALPHABET = "abcdefghjkmnpqrstuvwxyzABCDEFGHJKLMNPQRSTUVWXYZ23456789";

  /** Who waits for a hash holds a thread, which others need for their requests. */
  private static final int MOST_WAITING = 12;

  private static final int GROUPS = 4;
  private static final int GROUP = 5;

  private final SecureRandom random = new SecureRandom();
  private final BCryptPasswordEncoder encoder = new BCryptPasswordEncoder(STRENGTH, random);

  /** A hash costs a quarter of a second: attempts to sign in must not take the whole machine. */
  private final Semaphore atOnce = new Semaphore(2, true);

  private final String nobodys = encoder.encode(fresh());

  /** A random password of more than 115 bits. */
  String fresh() {
    StringBuilder password = new StringBuilder();
    for (int i = 0; i < GROUPS * GROUP; i++) {
      if (i > 0 && i % GROUP == 0) {
        password.append('-');
      }
      password.append(ALPHABET.charAt(random.nextInt(ALPHABET.length())));
    }
    return password.toString();
  }

  /**
   * What is stored of a password.
   *
   * @throws Refusal when it is too short or too long
   */
  String hash(String password) {
    if (password.length() < SHORTEST
        || password.getBytes(StandardCharsets.UTF_8).length > LONGEST) {
      throw Refusal.malformed(
          "A password has at least "
              + SHORTEST
              + " characters, and at most "
              + LONGEST
              + " bytes in UTF-8.");
    }
    return taken(() -> encoder.encode(password));
  }

  /**
   * Whether a password is the one that was hashed; takes as long where there is none.
   *
   * @param hash null where the person is not known, or has no password
   * @throws Refusal when too many others wait for the same
   */
  boolean matches(String password, @Nullable String hash) {
    boolean same = taken(() -> encoder.matches(password, hash == null ? nobodys : hash));
    return same && hash != null;
  }

  private <T> T taken(Supplier<T> work) {
    // Two who look at the same moment may both wait: the bound is near enough.
    if (atOnce.getQueueLength() >= MOST_WAITING) {
      throw Refusal.busy("Too many people sign in at this moment; try again in some seconds.");
    }
    atOnce.acquireUninterruptibly();
    try {
      return work.get();
    } finally {
      atOnce.release();
    }
  }
}
