package org.sitaf.server.git.remote;

import java.util.Optional;

/** What a repository is read with. */
public sealed interface Credential {
  /** What must be kept secret; empty if there is nothing. */
  Optional<String> secret();

  /** Nothing: the repository is public. */
  record None() implements Credential {
    @Override
    public Optional<String> secret() {
      return Optional.empty();
    }
  }

  /** A token or a password of a user, for https. */
  record Token(String user, String token) implements Credential {
    @Override
    public Optional<String> secret() {
      return Optional.of(token);
    }

    @Override
    public String toString() {
      return "Token[" + user + "]";
    }
  }

  /** A private key without a passphrase, in the format of OpenSSH or PEM, for ssh. */
  record DeployKey(String privateKey) implements Credential {
    @Override
    public Optional<String> secret() {
      return Optional.of(privateKey);
    }

    @Override
    public String toString() {
      return "DeployKey";
    }
  }
}
