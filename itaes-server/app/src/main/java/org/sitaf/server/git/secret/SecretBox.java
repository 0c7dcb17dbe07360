package org.sitaf.server.git.secret;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;
import java.util.Set;
import javax.crypto.Cipher;
import javax.crypto.SecretKey;
import javax.crypto.spec.GCMParameterSpec;
import javax.crypto.spec.SecretKeySpec;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.boot.context.properties.EnableConfigurationProperties;
import org.springframework.stereotype.Component;

/**
 * Encrypts secrets that the server must be able to read again. The key is a file, so that a copy of
 * the database reveals nothing. AES-256 in Galois/Counter Mode (NIST SP 800-38D).
 */
@Component
@EnableConfigurationProperties(GitSettings.class)
public class SecretBox {
  private static final String ALGORITHM = "AES/GCM/NoPadding";
  private static final int KEY_BYTES = 32;
  private static final int NONCE_BYTES = 12;
  private static final int TAG_BITS = 128;

  private final Path file;
  private final SecureRandom random = new SecureRandom();
  private volatile @Nullable SecretKey key;

  SecretBox(GitSettings settings, SitafSettings server) {
    Path configured = settings.keyFile();
    this.file = configured == null ? server.dataDirectory().resolve("git.key") : configured;
  }

  /**
   * Encrypts a secret.
   *
   * @param owner what it belongs to; it can be decrypted only for the same owner
   */
  public String encrypt(String secret, String owner) {
    byte[] nonce = new byte[NONCE_BYTES];
    random.nextBytes(nonce);
    try {
      byte[] encrypted =
          cipher(Cipher.ENCRYPT_MODE, nonce, owner)
              .doFinal(secret.getBytes(StandardCharsets.UTF_8));
      return Base64.getEncoder()
          .encodeToString(
              ByteBuffer.allocate(nonce.length + encrypted.length)
                  .put(nonce)
                  .put(encrypted)
                  .array());
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every Java has " + ALGORITHM, e);
    }
  }

  /**
   * Decrypts a secret.
   *
   * @throws RequestException if it was encrypted with another key or for another owner
   */
  public String decrypt(String text, String owner) {
    byte[] bytes = Base64.getDecoder().decode(text);
    try {
      return new String(
          cipher(Cipher.DECRYPT_MODE, Arrays.copyOf(bytes, NONCE_BYTES), owner)
              .doFinal(bytes, NONCE_BYTES, bytes.length - NONCE_BYTES),
          StandardCharsets.UTF_8);
    } catch (GeneralSecurityException e) {
      throw RequestException.conflict(
          "The stored credential cannot be decrypted with the server's key; enter the credential"
              + " again, or start the server with the key file that was used"
              + " (sitaf.git.key-file).");
    }
  }

  private Cipher cipher(int mode, byte[] nonce, String owner) throws GeneralSecurityException {
    Cipher cipher = Cipher.getInstance(ALGORITHM);
    cipher.init(mode, key(), new GCMParameterSpec(TAG_BITS, nonce));
    cipher.updateAAD(owner.getBytes(StandardCharsets.UTF_8));
    return cipher;
  }

  private synchronized SecretKey key() {
    SecretKey known = key;
    if (known == null) {
      known = new SecretKeySpec(read(), "AES");
      key = known;
    }
    return known;
  }

  private byte[] read() {
    try {
      if (!Files.exists(file)) {
        create();
      }
      byte[] bytes = HexFormat.of().parseHex(Files.readString(file).strip());
      if (bytes.length != KEY_BYTES) {
        throw new IllegalArgumentException("it has " + bytes.length + " bytes");
      }
      return bytes;
    } catch (IOException e) {
      throw new UncheckedIOException("The key of the credentials cannot be read: " + file, e);
    } catch (IllegalArgumentException e) {
      throw new IllegalStateException(
          file + " must hold " + KEY_BYTES + " bytes in hexadecimal: " + e.getMessage(), e);
    }
  }

  private void create() throws IOException {
    byte[] bytes = new byte[KEY_BYTES];
    random.nextBytes(bytes);
    byte[] text = HexFormat.of().formatHex(bytes).getBytes(StandardCharsets.US_ASCII);
    try (var channel =
        Files.newByteChannel(
            file,
            Set.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")))) {
      channel.write(ByteBuffer.wrap(text));
    } catch (FileAlreadyExistsException e) {
      // Another server was faster; its key counts.
    }
  }
}
