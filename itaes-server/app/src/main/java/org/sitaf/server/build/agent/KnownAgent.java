package org.sitaf.server.build.agent;

import jakarta.persistence.CollectionTable;
import jakarta.persistence.ElementCollection;
import jakarta.persistence.Embeddable;
import jakarta.persistence.Entity;
import jakarta.persistence.FetchType;
import jakarta.persistence.Id;
import jakarta.persistence.JoinColumn;
import jakarta.persistence.OrderColumn;
import jakarta.persistence.Table;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;

/** An agent that registered once, connected or not. */
@Entity
@Table(name = "agent")
class KnownAgent {
  @Id private String name;
  private String version;
  private int slots;
  private Instant lastSeen;

  @ElementCollection(fetch = FetchType.EAGER)
  @CollectionTable(name = "agent_toolchain", joinColumns = @JoinColumn(name = "agent_name"))
  @OrderColumn(name = "position")
  private List<Toolchain> toolchains = new ArrayList<>();

  /**
   * A language that an agent can compile and run.
   *
   * @param language java, cpp or python
   * @param version such as {@code javac 17.0.15}
   */
  @Embeddable
  record Toolchain(String language, String version) {}

  /** For the persistence provider. */
  protected KnownAgent() {
    name = "";
    version = "";
    lastSeen = Instant.EPOCH;
  }

  KnownAgent(String name) {
    this();
    this.name = name;
  }

  /** Takes over what the agent says of itself. */
  void register(String newVersion, int newSlots, List<Toolchain> newToolchains, Instant now) {
    version = newVersion;
    slots = newSlots;
    toolchains.clear();
    toolchains.addAll(newToolchains);
    lastSeen = now;
  }

  void seen(Instant when) {
    lastSeen = when;
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

  List<Toolchain> toolchains() {
    return List.copyOf(toolchains);
  }
}
