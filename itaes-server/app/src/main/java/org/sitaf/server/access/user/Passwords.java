package org.sitaf.server.access.user;

import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.error.RequestException;
import org.springframework.security.crypto.bcrypt.BCryptPasswordEncoder;
import org.springframework.stereotype.Component;

/** Hashes passwords with bcrypt and generates random ones. */
@Component
class Passwords {
  private static final int MIN_LENGTH = 12;

  /** Bcrypt ignores further bytes. */
  private static final int MAX_BYTES = 72;

  /** Without characters that look alike, because users type these passwords. */
  private static final String ALPHABET = "abcdefghjkmnpqrstuvwxyzABCDEFGHJKLMNPQRSTUVWXYZ23456789";

  /** Each waiting caller blocks a request thread. */
  private static final int MAX_WAITING = 12;

  private static final int GROUPS = 4;
  private static final int GROUP = 5;

  private final SecureRandom random = new SecureRandom();
  private final BCryptPasswordEncoder encoder;
  private final String dummyHash;

  /** A hash takes a quarter of a second of CPU time; sign-ins must not use all CPUs. */
  private final Semaphore permits = new Semaphore(2, true);

  Passwords(AccessSettings settings) {
    encoder = new BCryptPasswordEncoder(settings.passwordStrength(), random);
    dummyHash = encoder.encode(generate());
  }

  /** Generates a password with more than 115 random bits. */
  String generate() {
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
   * Hashes a password.
   *
   * @throws RequestException if the password is too short or too long
   */
  String hash(String password) {
    if (password.length() < MIN_LENGTH
        || password.getBytes(StandardCharsets.UTF_8).length > MAX_BYTES) {
      throw RequestException.malformed(
          "A password must have at least "
              + MIN_LENGTH
              + " characters and at most "
              + MAX_BYTES
              + " bytes in UTF-8.");
    }
    return limited(() -> encoder.encode(password));
  }

  /**
   * Checks a password. Takes the same time without a hash, so that it does not reveal which users
   * exist.
   *
   * @param hash null if the user is unknown or has no password
   * @throws RequestException if too many callers are waiting
   */
  boolean matches(String password, @Nullable String hash) {
    boolean matches = limited(() -> encoder.matches(password, hash == null ? dummyHash : hash));
    return matches && hash != null;
  }

  private <T> T limited(
      Supplier<T> work) { // Not exact under concurrency, which is good enough for this limit.
    if (permits.getQueueLength() >= MAX_WAITING) {
      throw RequestException.busy("Too many concurrent sign-ins; try again in some seconds.");
    }
    permits.acquireUninterruptibly();
    try {
      return work.get();
    } finally {
      permits.release();
    }
  }
}
