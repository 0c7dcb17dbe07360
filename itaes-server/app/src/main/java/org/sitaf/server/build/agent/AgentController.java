package org.sitaf.server.build.agent;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.enrolment.Enrolments;
import org.sitaf.server.build.agent.KnownAgent.Standing;
import org.sitaf.server.error.RequestException;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/agents")
@Tag(name = "agents")
class AgentController {
  private final Agents agents;
  private final Enrolments enrolments;
  private final Dispatcher dispatcher;

  AgentController(Agents agents, Dispatcher dispatcher, Enrolments enrolments) {
    this.enrolments = enrolments;
    this.agents = agents;
    this.dispatcher = dispatcher;
  }

  /** Whether the agent is connected. */
  enum State {
    ONLINE,
    OFFLINE
  }

  @Schema(name = "Toolchain")
  record ToolchainView(
      @Schema(description = "java, cpp or python") String language, String version) {}

  @Schema(name = "Agent")
  record AgentView(
      String name,
      String version,
      State state,
      @Schema(
              description =
                  "a DRAINING agent finishes its builds and gets no new ones; the builds of a"
                      + " DISABLED agent are also given to others")
          Standing standing,
      @Schema(description = "maximum number of concurrent builds") int slots,
      @Schema(description = "slots in use") int busy,
      List<ToolchainView> toolchains,
      @Schema(description = "whether it can run simulations") boolean simulation,
      Set<String> labels,
      @Schema(description = "names of the real devices that builds may use") Set<String> devices,
      @Schema(description = "why it accepts no builds, such as a full disk")
          @Nullable String refuses,
      Instant lastSeen) {}

  @Schema(name = "AgentStanding")
  record StandingRequest(Standing standing) {}

  @GetMapping
  @Operation(operationId = "listAgents", summary = "Lists agents by name")
  List<AgentView> list() {
    return agents.all().stream().map(this::view).toList();
  }

  @PutMapping("/{name}/standing")
  @Operation(operationId = "setAgentStanding", summary = "Activates, drains or disables an agent")
  AgentView setStanding(@PathVariable String name, @RequestBody StandingRequest request) {
    if (request.standing() == null) {
      throw RequestException.malformed("standing must be ACTIVE, DRAINING or DISABLED.");
    }
    agents.setStanding(name, request.standing());
    dispatcher.wake();
    return view(agents.find(name));
  }

  @DeleteMapping("/{name}")
  @Operation(
      operationId = "forgetAgent",
      summary = "Deletes an agent",
      description = "Fails with 409 while it is connected.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String name) {
    agents.delete(name);
    enrolments.revoke(name);
  }

  private AgentView view(KnownAgent agent) {
    Optional<AgentSession> session = agents.session(agent.name()).filter(AgentSession::isOpen);
    String refuses = session.map(AgentSession::refuses).orElse("");
    return new AgentView(
        agent.name(),
        agent.version(),
        agents.isOnline(agent) ? State.ONLINE : State.OFFLINE,
        agent.standing(),
        agent.slots(),
        session.map(AgentSession::busy).orElse(0),
        agent.offers().toolchains().stream()
            .map(t -> new ToolchainView(t.language(), t.version()))
            .toList(),
        agent.offers().simulation(),
        new TreeSet<>(agent.offers().labels()),
        new TreeSet<>(agent.offers().devices()),
        refuses.isEmpty() ? null : refuses,
        session.map(AgentSession::lastHeartbeat).orElse(agent.lastSeen()));
  }
}
