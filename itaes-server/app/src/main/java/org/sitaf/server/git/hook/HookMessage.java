package org.sitaf.server.git.hook;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Secret;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.git.source.Forge;

/**
 * A message of a forge. GitHub, Gitea and Forgejo sign the body with HMAC-SHA-256; GitLab sends the
 * secret itself.
 *
 * @param header returns a header of the request; null if it is missing
 */
@SuppressWarnings("ArrayRecordComponent") // Messages are not compared.
record HookMessage(byte[] body, Function<String, @Nullable String> header) {
  private static final String ALGORITHM = "HmacSHA256";
  private static final String SHA_256 = "sha256=";
  private static final int MAX_ID = 200;

  /** Whether the message was made with the secret; takes the same time for all wrong ones. */
  boolean isSignedWith(String secret) {
    String token = header.apply("X-Gitlab-Token");
    if (token != null) {
      return Secret.same(token, secret);
    }
    String signature =
        first("X-Hub-Signature-256", "X-Forgejo-Signature", "X-Gitea-Signature").orElse("");
    String hex = signature.startsWith(SHA_256) ? signature.substring(SHA_256.length()) : signature;
    return MessageDigest.isEqual(
        hmac(secret).getBytes(StandardCharsets.US_ASCII),
        hex.toLowerCase(Locale.ROOT).getBytes(StandardCharsets.US_ASCII));
  }

  private String hmac(String secret) {
    try {
      Mac mac = Mac.getInstance(ALGORITHM);
      mac.init(new SecretKeySpec(secret.getBytes(StandardCharsets.UTF_8), ALGORITHM));
      return HexFormat.of().formatHex(mac.doFinal(body));
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every Java has " + ALGORITHM, e);
    }
  }

  /** Identifies the message; a forge sends the same one again if it got no answer. */
  String id() {
    String id =
        first(
                "X-GitHub-Delivery",
                "X-Forgejo-Delivery",
                "X-Gitea-Delivery",
                "Idempotency-Key",
                "X-Gitlab-Event-UUID")
            .orElseGet(() -> StoredFiles.sha256(body));
    return id.length() <= MAX_ID ? id : StoredFiles.sha256(id.getBytes(StandardCharsets.UTF_8));
  }

  /** Whether it says that something was pushed. */
  boolean isPush() {
    return event().equals("push") || event().equals("Push Hook");
  }

  /** Whether it is about a pull or merge request. */
  boolean isRequest() {
    return event().equals("pull_request") || event().equals("Merge Request Hook");
  }

  private String event() {
    return first("X-Forgejo-Event", "X-Gitea-Event", "X-Gitlab-Event", "X-GitHub-Event").orElse("");
  }

  /** The kind of the sender. Gitea and Forgejo send the headers of GitHub, too. */
  Forge forge() {
    if (first("X-Forgejo-Event", "X-Gitea-Event").isPresent()) {
      return Forge.GITEA;
    }
    return first("X-Gitlab-Event").isPresent() ? Forge.GITLAB : Forge.GITHUB;
  }

  private Optional<String> first(String... names) {
    for (String name : names) {
      String value = header.apply(name);
      if (value != null && !value.isBlank()) {
        return Optional.of(value.strip());
      }
    }
    return Optional.empty();
  }
}
