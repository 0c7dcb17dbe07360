package org.sitaf.server.access;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import org.sitaf.core.digest.Sha256;

/**
 * Random secrets of 256 bits. They are stored as SHA-256 hashes; a slow hash is only needed for
 * secrets that can be guessed.
 */
public final class Secret {
  private static final int BYTES = 32;
  private static final SecureRandom RANDOM = new SecureRandom();

  private Secret() {}

  /**
   * Creates a secret of URL-safe characters.
   *
   * @param prefix identifies the kind of secret for people and for secret scanners
   */
  public static String generate(String prefix) {
    byte[] bytes = new byte[BYTES];
    RANDOM.nextBytes(bytes);
    return prefix + Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  /** The hash to store, in hexadecimal. */
  public static String hash(String secret) {
    return Sha256.hex(secret.getBytes(StandardCharsets.UTF_8));
  }

  /** Compares two secrets in constant time. */
  public static boolean same(String one, String other) {
    return MessageDigest.isEqual(
        hash(one).getBytes(StandardCharsets.US_ASCII),
        hash(other).getBytes(StandardCharsets.US_ASCII));
  }
}
