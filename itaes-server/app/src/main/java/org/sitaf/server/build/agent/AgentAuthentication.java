package org.sitaf.server.build.agent;

import com.google.protobuf.Descriptors.FieldDescriptor;
import com.google.protobuf.Message;
import io.grpc.Context;
import io.grpc.Contexts;
import io.grpc.ForwardingServerCallListener.SimpleForwardingServerCallListener;
import io.grpc.Grpc;
import io.grpc.Metadata;
import io.grpc.ServerCall;
import io.grpc.ServerCallHandler;
import io.grpc.ServerInterceptor;
import io.grpc.Status;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.server.access.enrolment.Enrolments;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.network.Addresses;
import org.sitaf.server.network.TrustedProxies;
import org.springframework.grpc.server.GlobalServerInterceptor;
import org.springframework.stereotype.Component;

/**
 * Authenticates agents by their keys and allows them to access their own attempts only. Enrolment
 * requires no key.
 */
@Component
@GlobalServerInterceptor
class AgentAuthentication implements ServerInterceptor {
  private static final Context.Key<String> AGENT = Context.key("sitaf-agent");
  private static final Context.Key<String> ADDRESS = Context.key("sitaf-address");
  private static final Metadata.Key<String> AUTHORIZATION =
      Metadata.Key.of("authorization", Metadata.ASCII_STRING_MARSHALLER);
  private static final String SCHEME = "Bearer ";
  private static final String ENROL = AgentServiceGrpc.getEnrolMethod().getFullMethodName();

  private final Enrolments enrolments;
  private final Attempts attempts;
  private final EnrolmentLimiter enrolmentLimiter;
  private final TrustedProxies proxies;

  AgentAuthentication(
      Enrolments enrolments,
      Attempts attempts,
      EnrolmentLimiter enrolmentLimiter,
      TrustedProxies proxies) {
    this.enrolments = enrolments;
    this.attempts = attempts;
    this.enrolmentLimiter = enrolmentLimiter;
    this.proxies = proxies;
  }

  /** The agent of the current call; empty for an enrolment. */
  static Optional<String> agent() {
    return Optional.ofNullable(AGENT.get());
  }

  /** The client address of the current call. */
  static String address() {
    String address = ADDRESS.get();
    return address == null ? "-" : address;
  }

  @Override
  public <Q, A> ServerCall.Listener<Q> interceptCall(
      ServerCall<Q, A> call, Metadata headers, ServerCallHandler<Q, A> next) {
    String address = addressOf(call, headers);
    Context context = Context.current().withValue(ADDRESS, address);
    if (call.getMethodDescriptor().getFullMethodName().equals(ENROL)) {
      return enrolmentLimiter.admit(
          Addresses.group(address),
          call,
          admitted -> Contexts.interceptCall(context, admitted, headers, next));
    }
    String header = headers.get(AUTHORIZATION);
    String key =
        header != null && header.startsWith(SCHEME) ? header.substring(SCHEME.length()) : "";
    String agent;
    try {
      agent = enrolments.agentOf(key).orElse(null);
    } catch (RuntimeException e) {
      call.close(GrpcStatus.exception(e).getStatus(), new Metadata());
      return new ServerCall.Listener<>() {};
    }
    if (agent == null) {
      call.close(unknownKey(), new Metadata());
      return new ServerCall.Listener<>() {};
    }
    return new CheckedListener<>(
        Contexts.interceptCall(context.withValue(AGENT, agent), call, headers, next),
        call,
        agent,
        key);
  }

  private static Status unknownKey() {
    return Status.UNAUTHENTICATED.withDescription(
        "the agent's key is unknown or was revoked; enrol the agent");
  }

  private String addressOf(ServerCall<?, ?> call, Metadata headers) {
    SocketAddress remote = call.getAttributes().get(Grpc.TRANSPORT_ATTR_REMOTE_ADDR);
    return remote instanceof InetSocketAddress inet
        ? proxies
            .client(inet.getAddress().getHostAddress(), name -> values(headers, name))
            .address()
        : String.valueOf(remote);
  }

  private static List<String> values(Metadata headers, String name) {
    Iterable<String> values =
        headers.getAll(
            Metadata.Key.of(name.toLowerCase(Locale.ROOT), Metadata.ASCII_STRING_MARSHALLER));
    List<String> all = new ArrayList<>();
    if (values != null) {
      values.forEach(all::add);
    }
    return all;
  }

  /** Checks each message of a stream, because the key may be revoked in the meantime. */
  private final class CheckedListener<Q> extends SimpleForwardingServerCallListener<Q> {
    private final ServerCall<Q, ?> call;
    private final String agent;
    private final String key;
    private boolean rejected;

    CheckedListener(
        ServerCall.Listener<Q> delegate, ServerCall<Q, ?> call, String agent, String key) {
      super(delegate);
      this.call = call;
      this.agent = agent;
      this.key = key;
    }

    @Override
    public void onMessage(Q message) {
      Status problem;
      try {
        problem = problemOf(message);
      } catch (RuntimeException e) {
        problem = GrpcStatus.exception(e).getStatus();
      }
      if (problem == null) {
        super.onMessage(message);
      } else {
        rejected = true;
        call.close(problem, new Metadata());
        super.onCancel();
      }
    }

    @Override
    public void onHalfClose() {
      if (!rejected) {
        super.onHalfClose();
      }
    }

    @Override
    public void onCancel() {
      if (!rejected) {
        super.onCancel();
      }
    }

    private @Nullable Status problemOf(Q message) {
      boolean isStream = !call.getMethodDescriptor().getType().clientSendsOneMessage();
      if (isStream && enrolments.agentOf(key).isEmpty()) {
        return unknownKey();
      }
      return message instanceof Message concrete && belongsToOtherAgent(concrete)
          ? Status.PERMISSION_DENIED.withDescription("the attempt belongs to another agent")
          : null;
    }

    /** False for unknown attempts, which the service rejects. */
    private boolean belongsToOtherAgent(Message message) {
      FieldDescriptor field = message.getDescriptorForType().findFieldByName("attempt");
      return field != null
          && message.getField(field) instanceof AttemptRef attempt
          && attempts
              .agentOf(Messages.toKey(attempt))
              .filter(owner -> !owner.equals(agent))
              .isPresent();
    }
  }
}
