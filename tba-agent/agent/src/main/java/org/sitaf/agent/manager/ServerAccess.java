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
 * How an agent gets in at its server.
 *
 * @param enrolmentToken lets the agent in for the first time; null for one that has its key
 * @param authorities file of the certificates that vouch for the server, in PEM; null for those
 *     that this machine trusts
 * @param plaintext whether to speak without TLS beyond the loopback
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

  /** Access to a server on the same machine. */
  public static ServerAccess byToken(String enrolmentToken) {
    return new ServerAccess(enrolmentToken, null, false);
  }

  /** TLS, except on the loopback: the agent's key must not be read on the way. */
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
