package org.sitaf.server.build.agent;

import com.google.protobuf.Duration;
import io.grpc.Status;
import io.grpc.stub.StreamObserver;
import java.time.Clock;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AgentMessage;
import org.sitaf.agent.v1.Heartbeat;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.Registered;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.settings.SitafSettings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Handles the messages of an agent's stream: Register first, then Heartbeats. */
final class AgentStream implements StreamObserver<AgentMessage> {
  private static final Logger log = LoggerFactory.getLogger(AgentStream.class);

  private final Agents agents;
  private final Dispatcher dispatcher;
  private final SitafSettings settings;
  private final Clock clock;
  private final StreamObserver<ServerMessage> responses;
  private @Nullable AgentSession session;

  AgentStream(
      Agents agents,
      Dispatcher dispatcher,
      SitafSettings settings,
      Clock clock,
      StreamObserver<ServerMessage> responses) {
    this.agents = agents;
    this.dispatcher = dispatcher;
    this.settings = settings;
    this.clock = clock;
    this.responses = responses;
  }

  @Override
  public void onNext(AgentMessage message) {
    try {
      switch (message.getMessageCase()) {
        case REGISTER -> register(message.getRegister());
        case HEARTBEAT -> heartbeat(message.getHeartbeat());
        case MESSAGE_NOT_SET -> throw invalid("message: must be Register or Heartbeat");
      }
    } catch (RuntimeException e) {
      fail(e);
    }
  }

  private void register(Register register) {
    if (session != null) {
      throw invalid("register: the agent is registered already");
    }
    Messages.verify(register);
    ReleaseCompatibility.requireCompatible(register.getVersion(), version());
    if (AgentAuthentication.agent().filter(register.getName()::equals).isEmpty()) {
      throw Status.PERMISSION_DENIED
          .withDescription("the key does not belong to agent " + register.getName())
          .asRuntimeException();
    }
    List<AttemptKey> running = Messages.toKeys(register.getRunningList());
    AgentSession created =
        new AgentSession(
            register.getName(),
            register.getSlots(),
            Messages.toCapabilities(register),
            responses,
            agents.devices(running),
            clock.instant());
    created.setRefuses(register.getRefuses());
    if (!agents.add(created, register)) {
      throw Status.ALREADY_EXISTS
          .withDescription("an agent named " + register.getName() + " is connected already")
          .asRuntimeException();
    }
    session = created;
    // Before builds can be assigned to it, because it does not report those yet.
    agents.abandonUnknown(created, running);
    created.sendRegistered(
        ServerMessage.newBuilder()
            .setRegistered(
                Registered.newBuilder()
                    .setServerVersion(version())
                    .setLease(Duration.newBuilder().setSeconds(settings.lease().toSeconds())))
            .build());
    agents.heartbeat(created, running);
    log.info("Agent {} connected with {} slots", created.name(), created.slots());
    dispatcher.wake();
  }

  private void heartbeat(Heartbeat heartbeat) {
    List<AttemptKey> running = Messages.toKeys(heartbeat.getRunningList());
    AgentSession current = session;
    if (current == null) {
      throw invalid("heartbeat: register first");
    }
    boolean wasFull = !current.hasFreeSlot();
    current.setRefuses(Messages.toReason(heartbeat.getRefuses()));
    agents.heartbeat(current, running);
    if (wasFull && current.hasFreeSlot()) {
      dispatcher.wake();
    }
  }

  @Override
  public void onError(Throwable error) {
    end();
  }

  @Override
  public void onCompleted() {
    end();
  }

  private void end() {
    AgentSession current = session;
    if (current != null) {
      log.info("Agent {} disconnected", current.name());
      agents.remove(current);
      session = null;
    }
  }

  private void fail(RuntimeException e) {
    AgentSession current = session;
    if (current == null) {
      responses.onError(GrpcStatus.exception(e));
    } else {
      current.close(GrpcStatus.exception(e));
      end();
    }
  }

  private static RuntimeException invalid(String message) {
    return Status.INVALID_ARGUMENT.withDescription(message).asRuntimeException();
  }

  private static String version() {
    String version = AgentStream.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }
}
