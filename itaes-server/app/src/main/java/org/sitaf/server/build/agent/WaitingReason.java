package org.sitaf.server.build.agent;

import java.time.Clock;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.agent.KnownAgent.Standing;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.stereotype.Component;

/** Says to people why a build waits. */
@Component
public class WaitingReason {
  private final Agents agents;
  private final DiskSpace disk;
  private final Clock clock;

  WaitingReason(Agents agents, DiskSpace disk, Clock clock) {
    this.agents = agents;
    this.disk = disk;
    this.clock = clock;
  }

  /** Such as "no agent offers cpp; 2 agents are offline". */
  public String of(Build build) {
    if (build.parts() > 0) {
      return "its " + build.parts() + " shards wait for agents";
    }
    Optional<String> full = disk.whyNoNewWork();
    if (full.isPresent()) {
      return full.get();
    }
    Instant notBefore = build.notBefore().orElse(Instant.MIN);
    if (notBefore.isAfter(clock.instant())) {
      return "it failed for a reason outside of it and is tried again at " + notBefore;
    }
    List<KnownAgent> known = agents.shown();
    List<KnownAgent> online = known.stream().filter(agents::isOnline).toList();
    String others = offline(known.size() - online.size());
    if (online.isEmpty()) {
      return "no agent is connected" + others;
    }
    Requirements requirements = build.requirements();
    List<KnownAgent> able = online.stream().filter(a -> requirements.areMetBy(a.offers())).toList();
    if (able.isEmpty()) {
      String lack =
          requirements
              .metByNone(online.stream().map(KnownAgent::offers).toList())
              .orElse(requirements.words() + " together");
      return "no agent offers " + lack + others;
    }
    List<KnownAgent> willing = able.stream().filter(a -> a.standing() == Standing.ACTIVE).toList();
    if (willing.isEmpty()) {
      return agentsAre(able.size(), "set aside (draining or disabled)") + others;
    }
    List<String> refusals = willing.stream().map(this::refusal).toList();
    if (refusals.stream().noneMatch(String::isEmpty)) {
      return agentsAre(willing.size(), "not taking builds: " + refusals.get(0)) + others;
    }
    boolean free =
        willing.stream()
            .anyMatch(a -> agents.session(a.name()).map(AgentSession::hasFreeSlot).orElse(false));
    return free
        ? "about to be given to an agent"
        : agentsAre(willing.size(), "busy with other builds") + others;
  }

  private String refusal(KnownAgent agent) {
    return agents.session(agent.name()).map(AgentSession::refuses).orElse(agent.refuses());
  }

  private static String offline(int count) {
    return count <= 0 ? "" : "; " + agentsAre(count, "offline");
  }

  private static String agentsAre(long count, String what) {
    return count == 1 ? "1 agent is " + what : count + " agents are " + what;
  }
}
