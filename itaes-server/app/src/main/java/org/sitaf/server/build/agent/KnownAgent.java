package org.sitaf.server.build.agent;

import jakarta.persistence.CollectionTable;
import jakarta.persistence.ElementCollection;
import jakarta.persistence.Embeddable;
import jakarta.persistence.Entity;
import jakarta.persistence.EnumType;
import jakarta.persistence.Enumerated;
import jakarta.persistence.FetchType;
import jakarta.persistence.Id;
import jakarta.persistence.JoinColumn;
import jakarta.persistence.OrderColumn;
import jakarta.persistence.Table;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.sitaf.server.build.request.Capabilities;

/** An agent that registered once, connected or not. */
@Entity
@Table(name = "agent")
class KnownAgent {
  @Id private String name;
  private String version;
  private int slots;
  private Instant lastSeen;

  /** Whether it has a stream to some server, as far as that server lives. */
  private boolean connected;

  @ElementCollection(fetch = FetchType.EAGER)
  @CollectionTable(name = "agent_toolchain", joinColumns = @JoinColumn(name = "agent_name"))
  @OrderColumn(name = "position")
  private List<Toolchain> toolchains = new ArrayList<>();

  private String labels;
  private boolean simulation;

  @Enumerated(EnumType.STRING)
  private Standing standing = Standing.ACTIVE;

  /** Why it takes no builds, as it says itself; empty where it does. */
  private String refuses;

  /** What people have decided about an agent. */
  enum Standing {
    ACTIVE,
    /** Finishes what it has and is given nothing more. */
    DRAINING,
    /** Is given nothing, and what it had was given to others. */
    DISABLED
  }

  /** As in {@link Capabilities.Toolchain}. */
  @Embeddable
  record Toolchain(String language, String version) {}

  /** For the persistence provider. */
  protected KnownAgent() {
    name = "";
    version = "";
    labels = "";
    refuses = "";
    lastSeen = Instant.EPOCH;
  }

  KnownAgent(String name) {
    this();
    this.name = name;
  }

  /** Takes over what the agent says of itself. */
  void register(
      String newVersion, int newSlots, Capabilities offers, String refusesNow, Instant now) {
    version = newVersion;
    slots = newSlots;
    toolchains.clear();
    offers.toolchains().forEach(t -> toolchains.add(new Toolchain(t.language(), t.version())));
    labels = String.join(",", new TreeSet<>(offers.labels()));
    simulation = offers.simulation();
    refuses = refusesNow;
    lastSeen = now;
    connected = true;
  }

  void disconnect(Instant when) {
    lastSeen = when;
    connected = false;
  }

  /** Whether a server said so lately. */
  boolean isConnected(Instant since) {
    return connected && !lastSeen.isBefore(since);
  }

  void stand(Standing decided) {
    standing = decided;
  }

  Standing standing() {
    return standing;
  }

  String refuses() {
    return refuses;
  }

  Capabilities offers() {
    return new Capabilities(
        toolchains.stream()
            .map(t -> new Capabilities.Toolchain(t.language(), t.version()))
            .toList(),
        simulation,
        labels.isEmpty() ? Set.of() : Set.of(labels.split(",")));
  }

  String name() {
    return name;
  }

  String version() {
    return version;
  }

  int slots() {
    return slots;
  }

  Instant lastSeen() {
    return lastSeen;
  }
}
