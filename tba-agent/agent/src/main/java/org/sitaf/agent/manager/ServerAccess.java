package org.sitaf.agent.manager;

import io.grpc.ChannelCredentials;
import io.grpc.InsecureChannelCredentials;
import io.grpc.TlsChannelCredentials;
import java.io.IOException;
import java.nio.file.Path;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Credentials and TLS settings of an agent.
 *
 * @param enrolmentToken for the first start; null if the agent has a key
 * @param authorities file of trusted certificates in PEM; null for those of this machine
 * @param plaintext whether to connect without TLS to servers on other machines
 */
public record ServerAccess(
    @Nullable String enrolmentToken, @Nullable Path authorities, boolean plaintext) {
  private static final Pattern LOOPBACK =
      Pattern.compile("(localhost|127\\.\\d+\\.\\d+\\.\\d+|\\[::1])(:\\d+)?|unix:.*");

  public ServerAccess {
    if (plaintext && authorities != null) {
      throw new IllegalArgumentException("--plaintext and --ca exclude each other");
    }
  }

  /** Access to a server on this machine. */
  public static ServerAccess byToken(String enrolmentToken) {
    return new ServerAccess(enrolmentToken, null, false);
  }

  /** TLS, except on the loopback interface, because calls contain the agent's key. */
  ChannelCredentials channelCredentials(String server) throws IOException {
    if (authorities != null) {
      return TlsChannelCredentials.newBuilder().trustManager(authorities.toFile()).build();
    }
    boolean here =
        Stream.of(server.split("\\s*,\\s*")).allMatch(one -> LOOPBACK.matcher(one).matches());
    return plaintext || here ? InsecureChannelCredentials.create() : TlsChannelCredentials.create();
  }

  @Override
  public String toString() {
    return "ServerAccess[authorities=" + authorities + ", plaintext=" + plaintext + "]";
  }
}
