package org.sitaf.server.build.agent;

import io.grpc.Status;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import org.sitaf.agent.v1.Cancellation;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.build.Leases;
import org.sitaf.server.build.agent.KnownAgent.Standing;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.Database;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.stereotype.Component;
import org.springframework.transaction.event.TransactionalEventListener;
import org.springframework.transaction.support.TransactionTemplate;

/** The agents: who is connected, and who ever was. */
@Component
class Agents {
  /** How long what other servers with the same database change may go unseen. */
  private static final Duration SHOWN_FOR = Duration.ofSeconds(1);

  private final AtomicReference<Shown> shown = new AtomicReference<>(Shown.nothing());
  private final Map<String, AgentSession> sessions = new ConcurrentHashMap<>();
  private final KnownAgentRepository known;
  private final Leases leases;
  private final TransactionTemplate transaction;
  private final Database database;
  private final SitafSettings settings;
  private final DiskSpace disk;
  private final Clock clock;

  Agents(
      KnownAgentRepository known,
      Leases leases,
      TransactionTemplate transaction,
      Database database,
      SitafSettings settings,
      DiskSpace disk,
      Clock clock) {
    this.known = known;
    this.leases = leases;
    this.transaction = transaction;
    this.database = database;
    this.settings = settings;
    this.disk = disk;
    this.clock = clock;
  }

  /**
   * Takes in a session.
   *
   * @return false when another live stream has the same name
   */
  boolean add(AgentSession session, Register register) {
    AgentSession winner =
        sessions.compute(
            session.name(),
            (name, present) ->
                present != null && present.isOpen() && !isSilent(present) ? present : session);
    if (winner != session) {
      return false;
    }
    try {
      remember(session.name(), register);
    } catch (RuntimeException e) {
      sessions.remove(session.name(), session);
      throw e;
    }
    return true;
  }

  private void remember(String name, Register register) {
    change(
        () -> {
          KnownAgent agent = known.findById(name).orElseGet(() -> new KnownAgent(name));
          agent.register(
              register.getVersion(),
              register.getSlots(),
              Messages.toCapabilities(register),
              register.getRefuses(),
              now());
          known.save(agent);
        });
  }

  /** The session's stream has ended. */
  void remove(AgentSession session) {
    session.close(null);
    if (sessions.remove(session.name(), session) && disk.canWrite()) {
      change(
          () -> known.findById(session.name()).ifPresent(a -> a.disconnect(session.lastHeard())));
    }
  }

  /**
   * An agent has come: what it had and does not know of is lost, and need not wait for its lease.
   */
  void came(AgentSession session, Collection<AttemptKey> running) {
    leases.giveUpAllBut(session.name(), running);
  }

  /**
   * A sign of life of an agent: renews its leases, and stops what it should not work on any more.
   */
  void heard(AgentSession session, Collection<AttemptKey> running) {
    // Most agents are idle most of the time, and hundreds of them need no transaction to say so.
    // While the disk is full nobody can renew a lease, and none ends.
    Set<AttemptKey> outdated =
        running.isEmpty() || !disk.canWrite() ? Set.of() : leases.renew(session.name(), running);
    session.heard(running, now());
    Set<Long> unspoken = session.unspokenOf(running);
    if (!unspoken.isEmpty()) {
      session.free(leases.over(unspoken));
    }
    outdated.forEach(
        key -> {
          session.stopped(key);
          // Why is not known here; of one that was cancelled no late result is taken either way.
          cancel(session, key, "the attempt is over", true);
        });
  }

  /** Closes the streams of agents that have been silent for a lease. */
  void closeSilent() {
    for (AgentSession session : sessions.values()) {
      if (isSilent(session)) {
        session.close(
            Status.UNAVAILABLE
                .withDescription("nothing was heard for a lease; register again")
                .asRuntimeException());
        remove(session);
      }
    }
  }

  /** Ends all streams, because the server stops; agents dial again until it is back. */
  void closeAll() {
    connected()
        .forEach(
            session ->
                session.close(
                    Status.UNAVAILABLE
                        .withDescription("the server stops; dial again")
                        .asRuntimeException()));
  }

  Collection<AgentSession> connected() {
    return List.copyOf(sessions.values());
  }

  Optional<AgentSession> session(String name) {
    return Optional.ofNullable(sessions.get(name));
  }

  List<KnownAgent> all() {
    return known.findAllByOrderByName();
  }

  /**
   * All that there are, for the eyes of people: many look at once, and hundreds of agents may be.
   */
  List<KnownAgent> shown() {
    Instant now = now();
    Shown last = shown.get();
    if (now.isBefore(last.until())) {
      return last.agents();
    }
    Shown fresh = new Shown(all(), now.plus(SHOWN_FOR));
    // Not if an agent changed meanwhile: this may have been read before that.
    var unused = shown.compareAndSet(last, fresh);
    return fresh.agents();
  }

  private record Shown(List<KnownAgent> agents, Instant until) {
    /** Another one each time, so that what is shown is never taken for what was. */
    static Shown nothing() {
      return new Shown(List.of(), Instant.MIN);
    }
  }

  private void change(Runnable change) {
    transaction.executeWithoutResult(status -> change.run());
    shown.set(Shown.nothing());
  }

  KnownAgent find(String name) {
    return known.findById(name).orElseThrow(() -> Refusal.notFound("agent", name));
  }

  /** Agents that people do not want to be given builds. */
  Set<String> toSpare() {
    return known.findNamesToSpare();
  }

  /** What people decide about an agent; one that is disabled loses what it works on to others. */
  void stand(String name, Standing standing) {
    change(
        () -> {
          KnownAgent agent = find(name);
          agent.stand(standing);
          known.save(agent);
        });
    if (standing == Standing.DISABLED) {
      leases.giveUpAll(name, "agent " + name + " was disabled");
    }
  }

  /** Forgets an agent that is not connected. */
  void forget(String name) {
    change(
        () -> {
          KnownAgent agent = find(name);
          if (isOnline(agent)) {
            throw Refusal.conflict(
                "Agent '" + name + "' is connected; stop it first, or disable it.");
          }
          known.delete(agent);
        });
  }

  /** Connected to this server, or heard of by another one not long ago. */
  boolean isOnline(KnownAgent agent) {
    return session(agent.name()).map(AgentSession::isOpen).orElse(false)
        || (database.isShared() && agent.isConnected(now().minus(settings.lease())));
  }

  /** Tells other servers with the same database who is connected here. */
  void noteConnected() {
    if (database.isShared() && !sessions.isEmpty()) {
      Instant now = now();
      List<String> heard =
          sessions.values().stream()
              .filter(session -> session.isOpen() && !isSilent(session))
              .map(AgentSession::name)
              .toList();
      transaction.executeWithoutResult(status -> known.noteSeen(heard, now));
    }
  }

  @TransactionalEventListener
  void on(BuildEvent.Stopped stopped) {
    session(stopped.agent())
        .ifPresent(
            session -> {
              session.stopped(stopped.attempt());
              cancel(session, stopped.attempt(), stopped.reason(), stopped.givenUp());
            });
  }

  @TransactionalEventListener
  void on(BuildEvent.Delivered delivered) {
    session(delivered.agent()).ifPresent(session -> session.delivered(delivered.attempt()));
  }

  private static void cancel(AgentSession session, AttemptKey key, String reason, boolean givenUp) {
    session.send(
        ServerMessage.newBuilder()
            .setCancellation(
                Cancellation.newBuilder()
                    .setAttempt(Messages.toRef(key))
                    .setReason(reason)
                    .setGivenUp(givenUp))
            .build());
  }

  private boolean isSilent(AgentSession session) {
    return session.lastHeard().plus(settings.lease()).isBefore(now());
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
