package org.sitaf.server.build.agent;

import io.grpc.StatusRuntimeException;
import io.grpc.stub.StreamObserver;
import java.time.Instant;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.request.Capabilities;

/** The stream of a connected agent, and the slots and real devices that its attempts occupy. */
final class AgentSession {
  private final String name;
  private final int slots;
  private final Capabilities offers;
  private final StreamObserver<ServerMessage> stream;

  /** The real devices of attempts, by token. */
  private final Map<Long, Set<String>> occupied = new HashMap<>();

  private final Set<Long> stopped = new HashSet<>();
  private Instant lastHeartbeat;
  private boolean open = true;
  private boolean registered;
  private String refuses = "";

  /**
   * Creates a session.
   *
   * @param running attempts that the agent is executing already, with their real devices
   */
  AgentSession(
      String name,
      int slots,
      Capabilities offers,
      StreamObserver<ServerMessage> stream,
      Map<Long, Set<String>> running,
      Instant now) {
    this.name = name;
    this.slots = slots;
    this.offers = offers;
    this.stream = stream;
    this.lastHeartbeat = now;
    occupied.putAll(running);
  }

  String name() {
    return name;
  }

  int slots() {
    return slots;
  }

  Capabilities offers() {
    return offers;
  }

  synchronized boolean hasFreeSlot() {
    return open && registered && refuses.isEmpty() && occupied.size() < slots;
  }

  synchronized int freeSlots() {
    return hasFreeSlot() ? slots - occupied.size() : 0;
  }

  /** Whether no attempt uses one of the real devices. */
  synchronized boolean hasFree(Set<String> devices) {
    return occupied.values().stream().allMatch(used -> Collections.disjoint(used, devices));
  }

  /** Why the agent accepts no builds; empty if it does. */
  synchronized String refuses() {
    return refuses;
  }

  synchronized void setRefuses(String reason) {
    refuses = reason;
  }

  /**
   * Attempts that occupy slots but are not reported by the agent. They may have ended on another
   * server.
   */
  synchronized Set<Long> unreported(Collection<AttemptKey> running) {
    Set<Long> unreported = new HashSet<>(occupied.keySet());
    running.forEach(key -> unreported.remove(key.token()));
    return unreported;
  }

  synchronized void release(Collection<Long> tokens) {
    occupied.keySet().removeAll(tokens);
    stopped.removeAll(tokens);
  }

  synchronized int busy() {
    return occupied.size();
  }

  synchronized Instant lastHeartbeat() {
    return lastHeartbeat;
  }

  /**
   * Processes a heartbeat: releases the slots of stopped attempts that the agent no longer reports.
   */
  synchronized void heartbeat(Collection<AttemptKey> running, Instant now) {
    lastHeartbeat = now;
    Set<Long> ended = new HashSet<>(stopped);
    running.forEach(key -> ended.remove(key.token()));
    occupied.keySet().removeAll(ended);
    stopped.removeAll(ended);
  }

  /**
   * Marks an attempt that the server ended; its slot is occupied until the agent has stopped it.
   */
  synchronized void stopped(AttemptKey attempt) {
    if (occupied.containsKey(attempt.token())) {
      stopped.add(attempt.token());
    }
  }

  /** Releases the slot of an attempt whose outcome was delivered. */
  synchronized void delivered(AttemptKey attempt) {
    occupied.remove(attempt.token());
    stopped.remove(attempt.token());
  }

  synchronized void occupy(AttemptKey attempt, Set<String> devices) {
    occupied.put(attempt.token(), Set.copyOf(devices));
  }

  /** Sends the first message, after which builds can be assigned to the agent. */
  synchronized void sendRegistered(ServerMessage message) {
    registered = open;
    send(message);
  }

  /**
   * Sends a message if the agent is registered and the stream is open.
   *
   * @return whether the message was sent
   */
  synchronized boolean send(ServerMessage message) {
    if (!open || !registered) {
      return false;
    }
    try {
      stream.onNext(message);
      return true;
    } catch (RuntimeException e) {
      // The connection was lost; gRPC's callback ends the session.
      open = false;
      return false;
    }
  }

  synchronized boolean isOpen() {
    return open;
  }

  /** Closes the stream, with an error unless {@code error} is null. */
  synchronized void close(@Nullable StatusRuntimeException error) {
    if (!open) {
      return;
    }
    open = false;
    try {
      if (error == null) {
        stream.onCompleted();
      } else {
        stream.onError(error);
      }
    } catch (RuntimeException e) {
      // The stream is closed already.
      return;
    }
  }
}
