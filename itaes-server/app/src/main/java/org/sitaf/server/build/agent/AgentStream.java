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

/** The agent's side of its stream: Register first, Heartbeats then. */
final class AgentStream implements StreamObserver<AgentMessage> {
  private static final Logger log = LoggerFactory.getLogger(AgentStream.class);

  private final Agents agents;
  private final Dispatcher dispatcher;
  private final SitafSettings settings;
  private final Clock clock;
  private final StreamObserver<ServerMessage> answers;
  private @Nullable AgentSession session;

  AgentStream(
      Agents agents,
      Dispatcher dispatcher,
      SitafSettings settings,
      Clock clock,
      StreamObserver<ServerMessage> answers) {
    this.agents = agents;
    this.dispatcher = dispatcher;
    this.settings = settings;
    this.clock = clock;
    this.answers = answers;
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
    Releases.requireNear(register.getVersion(), version());
    if (AgentAuthentication.agent().filter(register.getName()::equals).isEmpty()) {
      throw Status.PERMISSION_DENIED
          .withDescription("the key is not that of an agent named " + register.getName())
          .asRuntimeException();
    }
    List<AttemptKey> running = Messages.toKeys(register.getRunningList());
    AgentSession made =
        new AgentSession(
            register.getName(),
            register.getSlots(),
            Messages.toCapabilities(register),
            answers,
            running,
            clock.instant());
    made.refuse(register.getRefuses());
    if (!agents.add(made, register)) {
      throw Status.ALREADY_EXISTS
          .withDescription("an agent named " + register.getName() + " is connected")
          .asRuntimeException();
    }
    session = made;
    // Before it can be given anything: what it is given from then on, it does not know of yet.
    agents.came(made, running);
    made.welcome(
        ServerMessage.newBuilder()
            .setRegistered(
                Registered.newBuilder()
                    .setServerVersion(version())
                    .setLease(Duration.newBuilder().setSeconds(settings.lease().toSeconds())))
            .build());
    agents.heard(made, running);
    log.info("Agent {} is connected, with {} slots", made.name(), made.slots());
    dispatcher.wake();
  }

  private void heartbeat(Heartbeat heartbeat) {
    List<AttemptKey> running = Messages.toKeys(heartbeat.getRunningList());
    AgentSession present = session;
    if (present == null) {
      throw invalid("heartbeat: register first");
    }
    boolean wasFull = !present.hasFreeSlot();
    present.refuse(Messages.toReason(heartbeat.getRefuses()));
    agents.heard(present, running);
    if (wasFull && present.hasFreeSlot()) {
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
    AgentSession present = session;
    if (present != null) {
      log.info("Agent {} is gone", present.name());
      agents.remove(present);
      session = null;
    }
  }

  private void fail(RuntimeException e) {
    AgentSession present = session;
    if (present == null) {
      answers.onError(StatusOf.exception(e));
    } else {
      present.close(StatusOf.exception(e));
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
