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

/** An agent in the database, connected or not. */
@Entity
@Table(name = "agent")
class KnownAgent {
  @Id private String name;
  private String version;
  private int slots;
  private Instant lastSeen;

  /** Whether it was connected to a server at {@code lastSeen}. */
  private boolean connected;

  @ElementCollection(fetch = FetchType.EAGER)
  @CollectionTable(name = "agent_toolchain", joinColumns = @JoinColumn(name = "agent_name"))
  @OrderColumn(name = "position")
  private List<Toolchain> toolchains = new ArrayList<>();

  private String labels;
  private String devices;
  private boolean simulation;
  private boolean analyses;

  @Enumerated(EnumType.STRING)
  private Standing standing = Standing.ACTIVE;

  /** Why it accepts no builds; empty if it does. */
  private String refuses;

  /** Whether builds are assigned to an agent; set by administrators. */
  enum Standing {
    ACTIVE,
    /** Finishes its builds and gets no new ones. */
    DRAINING,
    /** Gets no builds; its builds were given to other agents. */
    DISABLED
  }

  /** The database representation of {@link Capabilities.Toolchain}. */
  @Embeddable
  record Toolchain(String language, String version) {}

  /** For the persistence provider. */
  protected KnownAgent() {
    name = "";
    version = "";
    labels = "";
    devices = "";
    refuses = "";
    lastSeen = Instant.EPOCH;
  }

  KnownAgent(String name) {
    this();
    this.name = name;
  }

  /** Stores what the agent registered with. */
  void register(
      String newVersion, int newSlots, Capabilities offers, String newRefuses, Instant now) {
    version = newVersion;
    slots = newSlots;
    toolchains.clear();
    offers.toolchains().forEach(t -> toolchains.add(new Toolchain(t.language(), t.version())));
    labels = String.join(",", new TreeSet<>(offers.labels()));
    devices = String.join(",", new TreeSet<>(offers.devices()));
    simulation = offers.simulation();
    analyses = offers.analyses();
    refuses = newRefuses;
    lastSeen = now;
    connected = true;
  }

  void disconnect(Instant when) {
    lastSeen = when;
    connected = false;
  }

  /** Whether a server saw the agent connected since the given time. */
  boolean isConnected(Instant since) {
    return connected && !lastSeen.isBefore(since);
  }

  void setStanding(Standing standing) {
    this.standing = standing;
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
        analyses,
        words(labels),
        words(devices));
  }

  private static Set<String> words(String list) {
    return list.isEmpty() ? Set.of() : Set.of(list.split(","));
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
