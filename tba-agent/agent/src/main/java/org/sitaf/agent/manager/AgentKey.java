package org.sitaf.agent.manager;

import io.grpc.CallOptions;
import io.grpc.Channel;
import io.grpc.ClientCall;
import io.grpc.ClientInterceptor;
import io.grpc.ForwardingClientCall.SimpleForwardingClientCall;
import io.grpc.Metadata;
import io.grpc.MethodDescriptor;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.EnumSet;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.EnrolRequest;

/**
 * The agent's key: issued by the server in exchange for an enrolment token, stored in a file that
 * only the agent's user can read, and sent with every call.
 */
final class AgentKey implements ClientInterceptor {
  private static final Metadata.Key<String> AUTHORIZATION =
      Metadata.Key.of("authorization", Metadata.ASCII_STRING_MARSHALLER);
  private static final int DEADLINE_S = 15;

  private final Path file;
  private final String agent;
  private final @Nullable String enrolmentToken;
  private volatile @Nullable String key;

  private AgentKey(Path file, String agent, @Nullable String enrolmentToken, @Nullable String key) {
    this.file = file;
    this.agent = agent;
    this.enrolmentToken = enrolmentToken;
    this.key = key;
  }

  /**
   * Reads the key from a file, or prepares the enrolment.
   *
   * @throws IOException if there is neither a key nor a token
   */
  static AgentKey open(Path file, String agent, @Nullable String enrolmentToken)
      throws IOException {
    boolean known = Files.exists(file);
    if (!known && enrolmentToken == null) {
      throw new IOException(
          "this agent is not enrolled yet; set SITAF_ENROLMENT_TOKEN to a token that an"
              + " administrator created on the page Agents of the portal");
    }
    return new AgentKey(
        file,
        agent,
        enrolmentToken,
        known ? Files.readString(file, StandardCharsets.US_ASCII).strip() : null);
  }

  /**
   * Requests a key, unless there is one.
   *
   * @throws StatusRuntimeException if the server refuses
   * @throws IOException if the key cannot be stored
   */
  void enrol(Channel channel) throws IOException {
    if (key != null) {
      return;
    }
    if (enrolmentToken == null) {
      throw Status.UNAUTHENTICATED
          .withDescription("the key was rejected; set SITAF_ENROLMENT_TOKEN to enroll again")
          .asRuntimeException();
    }
    String given =
        AgentServiceGrpc.newBlockingStub(channel)
            .withDeadlineAfter(DEADLINE_S, TimeUnit.SECONDS)
            .enrol(EnrolRequest.newBuilder().setToken(enrolmentToken).setName(agent).build())
            .getKey();
    store(given);
    key = given;
  }

  /** The server does not know the key, for example because it was deleted. */
  void refused() {
    if (enrolmentToken != null) {
      key = null;
    }
  }

  /** Writes the file atomically, with permissions for the owner only. */
  private void store(String given) throws IOException {
    Path fresh = file.resolveSibling(file.getFileName() + ".new");
    Files.deleteIfExists(fresh);
    try (var out =
        Files.newByteChannel(
            fresh,
            EnumSet.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")))) {
      out.write(StandardCharsets.US_ASCII.encode(given + "\n"));
    }
    Files.move(fresh, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
  }

  @Override
  public <Q, A> ClientCall<Q, A> interceptCall(
      MethodDescriptor<Q, A> method, CallOptions options, Channel next) {
    return new SimpleForwardingClientCall<>(next.newCall(method, options)) {
      @Override
      public void start(Listener<A> listener, Metadata headers) {
        String present = key;
        if (present != null) {
          headers.put(AUTHORIZATION, "Bearer " + present);
        }
        super.start(listener, headers);
      }
    };
  }
}
