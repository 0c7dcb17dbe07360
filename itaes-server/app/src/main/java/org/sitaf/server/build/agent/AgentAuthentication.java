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
 * Lets through the calls of agents that show their key, and of those only what concerns attempts of
 * their own. Enrolment alone needs no key.
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
  private final Strangers strangers;
  private final TrustedProxies proxies;

  AgentAuthentication(
      Enrolments enrolments, Attempts attempts, Strangers strangers, TrustedProxies proxies) {
    this.enrolments = enrolments;
    this.attempts = attempts;
    this.strangers = strangers;
    this.proxies = proxies;
  }

  /** The agent that makes the present call; empty in an enrolment. */
  static Optional<String> agent() {
    return Optional.ofNullable(AGENT.get());
  }

  /** From where the present call comes. */
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
      return strangers.admit(
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
      call.close(StatusOf.exception(e).getStatus(), new Metadata());
      return new ServerCall.Listener<>() {};
    }
    if (agent == null) {
      call.close(unknown(), new Metadata());
      return new ServerCall.Listener<>() {};
    }
    return new Checked<>(
        Contexts.interceptCall(context.withValue(AGENT, agent), call, headers, next),
        call,
        agent,
        key);
  }

  private static Status unknown() {
    return Status.UNAUTHENTICATED.withDescription(
        "the agent's key is unknown or revoked; enrol the agent");
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

  /** Looks at each message: a key may be revoked while a stream lives. */
  private final class Checked<Q> extends SimpleForwardingServerCallListener<Q> {
    private final ServerCall<Q, ?> call;
    private final String agent;
    private final String key;
    private boolean refused;

    Checked(ServerCall.Listener<Q> delegate, ServerCall<Q, ?> call, String agent, String key) {
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
        problem = StatusOf.exception(e).getStatus();
      }
      if (problem == null) {
        super.onMessage(message);
      } else {
        refused = true;
        call.close(problem, new Metadata());
        super.onCancel();
      }
    }

    @Override
    public void onHalfClose() {
      if (!refused) {
        super.onHalfClose();
      }
    }

    @Override
    public void onCancel() {
      if (!refused) {
        super.onCancel();
      }
    }

    private @Nullable Status problemOf(Q message) {
      boolean streams = !call.getMethodDescriptor().getType().clientSendsOneMessage();
      if (streams && enrolments.agentOf(key).isEmpty()) {
        return unknown();
      }
      return message instanceof Message concrete && isOfAnother(concrete)
          ? Status.PERMISSION_DENIED.withDescription("the attempt is another agent's")
          : null;
    }

    /** What no attempt is known of is the service's to refuse. */
    private boolean isOfAnother(Message message) {
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
