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
import java.util.stream.Collectors;
import org.sitaf.agent.v1.Cancellation;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.build.Leases;
import org.sitaf.server.build.agent.KnownAgent.Standing;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.Database;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.stereotype.Component;
import org.springframework.transaction.support.TransactionTemplate;

/** The agents: sessions of connected agents, and all agents that ever registered. */
@Component
class Agents {
  /**
   * How long the list for users is cached; changes of other servers are visible after this time.
   */
  private static final Duration LIST_CACHED = Duration.ofSeconds(1);

  private final AtomicReference<CachedList> cachedList =
      new AtomicReference<>(CachedList.expired());
  private final Map<String, AgentSession> sessions = new ConcurrentHashMap<>();
  private final KnownAgentRepository repository;
  private final Leases leases;
  private final TransactionTemplate transaction;
  private final Database database;
  private final SitafSettings settings;
  private final DiskSpace disk;
  private final Clock clock;

  Agents(
      KnownAgentRepository repository,
      Leases leases,
      TransactionTemplate transaction,
      Database database,
      SitafSettings settings,
      DiskSpace disk,
      Clock clock) {
    this.repository = repository;
    this.leases = leases;
    this.transaction = transaction;
    this.database = database;
    this.settings = settings;
    this.disk = disk;
    this.clock = clock;
  }

  /**
   * Adds a session.
   *
   * @return false if an agent of the same name is connected
   */
  boolean add(AgentSession session, Register register) {
    AgentSession current =
        sessions.compute(
            session.name(),
            (name, present) ->
                present != null && present.isOpen() && !isSilent(present) ? present : session);
    if (current != session) {
      return false;
    }
    try {
      save(session.name(), register);
    } catch (RuntimeException e) {
      sessions.remove(session.name(), session);
      throw e;
    }
    return true;
  }

  private void save(String name, Register register) {
    change(
        () -> {
          KnownAgent agent = repository.findById(name).orElseGet(() -> new KnownAgent(name));
          agent.register(
              register.getVersion(),
              register.getSlots(),
              Messages.toCapabilities(register),
              register.getRefuses(),
              now());
          repository.save(agent);
        });
  }

  /** Removes a session whose stream has ended. */
  void remove(AgentSession session) {
    session.close(null);
    if (sessions.remove(session.name(), session) && disk.canWrite()) {
      change(
          () ->
              repository
                  .findById(session.name())
                  .ifPresent(a -> a.disconnect(session.lastHeartbeat())));
    }
  }

  /** The attempts by token, with the real devices that they use. */
  Map<Long, Set<String>> devices(Collection<AttemptKey> running) {
    Map<Long, Set<String>> known = running.isEmpty() ? Map.of() : leases.devices(running);
    return running.stream()
        .map(AttemptKey::token)
        .distinct()
        .collect(Collectors.toMap(token -> token, token -> known.getOrDefault(token, Set.of())));
  }

  /** Abandons the attempts that a new session does not report, without waiting for their leases. */
  void abandonUnknown(AgentSession session, Collection<AttemptKey> running) {
    leases.abandonAllExcept(session.name(), running);
  }

  /** Processes a heartbeat: renews the agent's leases and stops outdated attempts. */
  void heartbeat(AgentSession session, Collection<AttemptKey> running) {
    // Heartbeats of idle agents need no transaction. While the disk is full leases are neither
    // renewed nor do they expire.
    Set<AttemptKey> outdated =
        running.isEmpty() || !disk.canWrite() ? Set.of() : leases.renew(session.name(), running);
    session.heartbeat(running, now());
    Set<Long> unreported = session.unreported(running);
    if (!unreported.isEmpty()) {
      session.release(leases.ended(unreported));
    }
    outdated.forEach(
        key -> {
          session.stopped(key);
          // The reason is not known here. A late result of a cancelled build is not accepted.
          cancel(session, key, "the attempt has ended", true);
        });
  }

  /** Closes the streams of agents that sent nothing for the duration of a lease. */
  void closeSilent() {
    for (AgentSession session : sessions.values()) {
      if (isSilent(session)) {
        session.close(
            Status.UNAVAILABLE
                .withDescription("no heartbeat for the duration of a lease; register again")
                .asRuntimeException());
        remove(session);
      }
    }
  }

  /** Closes all streams because the server is stopping; agents reconnect later. */
  void closeAll() {
    connected()
        .forEach(
            session ->
                session.close(
                    Status.UNAVAILABLE
                        .withDescription("the server is stopping; reconnect later")
                        .asRuntimeException()));
  }

  Collection<AgentSession> connected() {
    return List.copyOf(sessions.values());
  }

  Optional<AgentSession> session(String name) {
    return Optional.ofNullable(sessions.get(name));
  }

  List<KnownAgent> all() {
    return repository.findAllByOrderByName();
  }

  /** All agents, cached for a short time because many users poll hundreds of agents. */
  List<KnownAgent> cached() {
    Instant now = now();
    CachedList last = cachedList.get();
    if (now.isBefore(last.until())) {
      return last.agents();
    }
    CachedList fresh = new CachedList(all(), now.plus(LIST_CACHED));
    // Not if an agent was changed in the meantime: the list may have been read before.
    var unused = cachedList.compareAndSet(last, fresh);
    return fresh.agents();
  }

  private record CachedList(List<KnownAgent> agents, Instant until) {
    /** A new instance for each call, because {@code compareAndSet} compares references. */
    static CachedList expired() {
      return new CachedList(List.of(), Instant.MIN);
    }
  }

  private void change(Runnable change) {
    transaction.executeWithoutResult(status -> change.run());
    cachedList.set(CachedList.expired());
  }

  KnownAgent find(String name) {
    return repository.findById(name).orElseThrow(() -> RequestException.notFound("agent", name));
  }

  /** Names of the agents that are draining or disabled. */
  Set<String> inactive() {
    return repository.findInactiveNames();
  }

  /** Activates, drains or disables an agent; the attempts of a disabled agent are abandoned. */
  void setStanding(String name, Standing standing) {
    change(
        () -> {
          KnownAgent agent = find(name);
          agent.setStanding(standing);
          repository.save(agent);
        });
    if (standing == Standing.DISABLED) {
      leases.abandonAll(name, "agent " + name + " was disabled");
    }
  }

  /** Deletes an agent that is not connected. */
  void delete(String name) {
    change(
        () -> {
          KnownAgent agent = find(name);
          if (isOnline(agent)) {
            throw RequestException.conflict(
                "Agent '" + name + "' is connected; stop it first, or disable it.");
          }
          repository.delete(agent);
        });
  }

  /** Whether the agent is connected to this server or to another one with the same database. */
  boolean isOnline(KnownAgent agent) {
    return session(agent.name()).map(AgentSession::isOpen).orElse(false)
        || (database.isShared() && agent.isConnected(now().minus(settings.lease())));
  }

  /** Stores which agents are connected, for other servers with the same database. */
  void saveConnected() {
    if (database.isShared() && !sessions.isEmpty()) {
      Instant now = now();
      List<String> names =
          sessions.values().stream()
              .filter(session -> session.isOpen() && !isSilent(session))
              .map(AgentSession::name)
              .toList();
      transaction.executeWithoutResult(status -> repository.saveSeen(names, now));
    }
  }

  /** Cancels an attempt that the server ended. */
  void stopped(BuildEvent.Stopped stopped) {
    session(stopped.agent())
        .ifPresent(
            session -> {
              session.stopped(stopped.attempt());
              cancel(session, stopped.attempt(), stopped.reason(), stopped.abandoned());
            });
  }

  /** Releases the slot of an attempt whose outcome was delivered. */
  void delivered(BuildEvent.Delivered delivered) {
    session(delivered.agent()).ifPresent(session -> session.delivered(delivered.attempt()));
  }

  private static void cancel(
      AgentSession session, AttemptKey key, String reason, boolean abandoned) {
    session.send(
        ServerMessage.newBuilder()
            .setCancellation(
                Cancellation.newBuilder()
                    .setAttempt(Messages.toRef(key))
                    .setReason(reason)
                    .setGivenUp(abandoned))
            .build());
  }

  private boolean isSilent(AgentSession session) {
    return session.lastHeartbeat().plus(settings.lease()).isBefore(now());
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
