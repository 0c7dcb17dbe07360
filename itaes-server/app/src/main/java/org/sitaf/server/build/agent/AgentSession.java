package org.sitaf.server.build.agent;

import io.grpc.StatusRuntimeException;
import io.grpc.stub.StreamObserver;
import java.time.Instant;
import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.request.Capabilities;

/** The stream of a connected agent, and the slots that its builds occupy. */
final class AgentSession {
  private final String name;
  private final int slots;
  private final Capabilities offers;
  private final StreamObserver<ServerMessage> stream;
  private final Set<Long> occupied = new HashSet<>();
  private final Set<Long> stopped = new HashSet<>();
  private Instant lastHeard;
  private boolean open = true;
  private boolean welcomed;
  private String refuses = "";

  /**
   * A session that begins.
   *
   * @param running attempts that the agent works on already
   */
  AgentSession(
      String name,
      int slots,
      Capabilities offers,
      StreamObserver<ServerMessage> stream,
      Collection<AttemptKey> running,
      Instant now) {
    this.name = name;
    this.slots = slots;
    this.offers = offers;
    this.stream = stream;
    this.lastHeard = now;
    running.forEach(key -> occupied.add(key.token()));
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
    return open && welcomed && refuses.isEmpty() && occupied.size() < slots;
  }

  synchronized int freeSlots() {
    return hasFreeSlot() ? slots - occupied.size() : 0;
  }

  /** Why it takes no builds, as it says; empty where it does. */
  synchronized String refuses() {
    return refuses;
  }

  synchronized void refuse(String why) {
    refuses = why;
  }

  /**
   * Slots that are taken by attempts which the agent does not speak of, in case they are over:
   * their end may have been told to another server.
   */
  synchronized Set<Long> unspokenOf(Collection<AttemptKey> running) {
    Set<Long> unspoken = new HashSet<>(occupied);
    running.forEach(key -> unspoken.remove(key.token()));
    return unspoken;
  }

  synchronized void free(Collection<Long> tokens) {
    occupied.removeAll(tokens);
    stopped.removeAll(tokens);
  }

  synchronized int busy() {
    return occupied.size();
  }

  synchronized Instant lastHeard() {
    return lastHeard;
  }

  /** Notes a sign of life; slots of stopped attempts that the agent has left are free again. */
  synchronized void heard(Collection<AttemptKey> running, Instant now) {
    lastHeard = now;
    Set<Long> left = new HashSet<>(stopped);
    running.forEach(key -> left.remove(key.token()));
    occupied.removeAll(left);
    stopped.removeAll(left);
  }

  /** The attempt is over on the server's side; its slot stays taken until the agent has left it. */
  synchronized void stopped(AttemptKey attempt) {
    if (occupied.contains(attempt.token())) {
      stopped.add(attempt.token());
    }
  }

  /** The agent has brought the attempt to its end. */
  synchronized void delivered(AttemptKey attempt) {
    occupied.remove(attempt.token());
    stopped.remove(attempt.token());
  }

  synchronized void occupy(AttemptKey attempt) {
    occupied.add(attempt.token());
  }

  /** Sends the first message, after which the agent may be given builds. */
  synchronized void welcome(ServerMessage message) {
    welcomed = open;
    send(message);
  }

  /**
   * Sends, if the agent was welcomed and the stream is open.
   *
   * @return whether it was
   */
  synchronized boolean send(ServerMessage message) {
    if (!open || !welcomed) {
      return false;
    }
    try {
      stream.onNext(message);
      return true;
    } catch (RuntimeException e) {
      // The transport is gone; its own callback ends the session.
      open = false;
      return false;
    }
  }

  synchronized boolean isOpen() {
    return open;
  }

  /** Ends the stream from this side; null for a regular end. */
  synchronized void close(@Nullable StatusRuntimeException why) {
    if (!open) {
      return;
    }
    open = false;
    try {
      if (why == null) {
        stream.onCompleted();
      } else {
        stream.onError(why);
      }
    } catch (RuntimeException e) {
      // It is closed already, which is what was wanted.
      return;
    }
  }
}
