package org.sitaf.server.git.remote;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.PublicKey;
import java.util.ArrayList;
import java.util.List;
import org.apache.sshd.common.config.keys.KeyUtils;
import org.apache.sshd.common.util.security.SecurityUtils;
import org.eclipse.jgit.transport.CredentialsProvider;
import org.eclipse.jgit.transport.sshd.ServerKeyDatabase;
import org.eclipse.jgit.transport.sshd.SshdSessionFactory;
import org.eclipse.jgit.transport.sshd.SshdSessionFactoryBuilder;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;

/**
 * Connects by SSH with a deploy key only: no key, agent, configuration or list of known hosts of
 * the server's user is used.
 */
final class SshSessions {
  private SshSessions() {}

  /**
   * Parses a private key.
   *
   * @throws RequestException if it is none, or if it has a passphrase
   */
  static List<KeyPair> keys(String privateKey) {
    List<KeyPair> keys = new ArrayList<>();
    try {
      Iterable<KeyPair> found =
          SecurityUtils.loadKeyPairIdentities(
              null,
              () -> "deploy key",
              new ByteArrayInputStream(privateKey.getBytes(StandardCharsets.UTF_8)),
              null);
      if (found != null) {
        found.forEach(keys::add);
      }
    } catch (IOException | GeneralSecurityException | RuntimeException e) {
      // Reported below; the message could quote the key.
    }
    if (keys.isEmpty()) {
      throw RequestException.malformed(
          "secret: is no RSA or ECDSA key without a passphrase in the format of OpenSSH or PEM;"
              + " create one with 'ssh-keygen -t ecdsa -N \"\"'.");
    }
    return keys;
  }

  static SshdSessionFactory of(Path folder, List<KeyPair> keys, HostKey hostKey) {
    File home = folder.toFile();
    return new SshdSessionFactoryBuilder()
        .setHomeDirectory(home)
        .setSshDirectory(home)
        .setPreferredAuthentications("publickey")
        .setConfigStoreFactory((homeDirectory, configFile, localUser) -> null)
        .setDefaultKeysProvider(directory -> keys)
        .setDefaultIdentities(directory -> List.of())
        .setDefaultKnownHostsFiles(directory -> List.of())
        .setConnectorFactory(null)
        .setServerKeyDatabase((homeDirectory, sshDirectory) -> hostKey)
        .build(null);
  }

  /** The key of the host: the first one that is seen is kept, and another one is refused. */
  static final class HostKey implements ServerKeyDatabase {
    private final @Nullable String known;
    private volatile @Nullable String seen;

    HostKey(@Nullable String known) {
      this.known = known;
    }

    @Nullable String seen() {
      return seen;
    }

    boolean isOther() {
      return known != null && seen != null && !known.equals(seen);
    }

    @Override
    public List<PublicKey> lookup(
        String address, InetSocketAddress remote, Configuration configuration) {
      return List.of();
    }

    @Override
    public boolean accept(
        String address,
        InetSocketAddress remote,
        PublicKey key,
        Configuration configuration,
        @Nullable CredentialsProvider provider) {
      String fingerprint = KeyUtils.getFingerPrint(key);
      seen = fingerprint;
      return known == null || known.equals(fingerprint);
    }
  }
}
