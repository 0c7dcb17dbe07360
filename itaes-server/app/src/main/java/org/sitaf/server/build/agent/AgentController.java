package org.sitaf.server.build.agent;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/agents")
@Tag(name = "agents")
class AgentController {
  private final Agents agents;

  AgentController(Agents agents) {
    this.agents = agents;
  }

  /** Whether there is a stream. */
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
      @Schema(description = "builds that may run at the same time") int slots,
      @Schema(description = "slots that are taken") int busy,
      List<ToolchainView> toolchains,
      Instant lastSeen) {}

  @GetMapping
  @Operation(
      operationId = "listAgents",
      summary = "Agents that are connected or once were, by name")
  List<AgentView> list() {
    return agents.all().stream().map(this::view).toList();
  }

  private AgentView view(KnownAgent agent) {
    Optional<AgentSession> session = agents.session(agent.name()).filter(AgentSession::isOpen);
    return new AgentView(
        agent.name(),
        agent.version(),
        session.isPresent() ? State.ONLINE : State.OFFLINE,
        agent.slots(),
        session.map(AgentSession::busy).orElse(0),
        agent.toolchains().stream().map(t -> new ToolchainView(t.language(), t.version())).toList(),
        session.map(AgentSession::lastHeard).orElse(agent.lastSeen()));
  }
}
