package org.sitaf.server.build.agent;

import java.time.Clock;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.agent.KnownAgent.Standing;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.stereotype.Component;

/** Explains to users why a build is queued. */
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

  /** Returns a reason such as "no agent offers cpp; 2 agents are offline". */
  public String of(Build build) {
    if (build.shards() > 0) {
      return "its " + build.shards() + " shards wait for agents";
    }
    Optional<String> full = disk.whyNoNewWork();
    if (full.isPresent()) {
      return full.get();
    }
    Instant notBefore = build.notBefore().orElse(Instant.MIN);
    if (notBefore.isAfter(clock.instant())) {
      return "it is retried at " + notBefore + " after an infrastructure failure";
    }
    List<KnownAgent> known = agents.cached();
    List<KnownAgent> online = known.stream().filter(agents::isOnline).toList();
    String others = offline(known.size() - online.size());
    if (online.isEmpty()) {
      return "no agent is connected" + others;
    }
    Requirements requirements = build.requirements();
    List<KnownAgent> able = online.stream().filter(a -> requirements.areMetBy(a.offers())).toList();
    if (able.isEmpty()) {
      String missing =
          requirements
              .metByNone(online.stream().map(KnownAgent::offers).toList())
              .orElse(requirements.words() + " together");
      return "no agent offers " + missing + others;
    }
    List<KnownAgent> active = able.stream().filter(a -> a.standing() == Standing.ACTIVE).toList();
    if (active.isEmpty()) {
      return agentsAre(able.size(), "draining or disabled") + others;
    }
    List<String> reasons = active.stream().map(this::refuses).toList();
    if (reasons.stream().noneMatch(String::isEmpty)) {
      return agentsAre(active.size(), "not accepting builds: " + reasons.get(0)) + others;
    }
    List<AgentSession> free =
        active.stream()
            .flatMap(a -> agents.session(a.name()).stream())
            .filter(AgentSession::hasFreeSlot)
            .toList();
    Set<String> devices = requirements.devices();
    if (!free.isEmpty() && free.stream().noneMatch(a -> a.hasFree(devices))) {
      return "another build uses "
          + (devices.size() == 1 ? "the device " : "one of the devices ")
          + String.join(", ", new TreeSet<>(devices));
    }
    return !free.isEmpty()
        ? "it is about to be assigned to an agent"
        : agentsAre(active.size(), "busy with other builds") + others;
  }

  private String refuses(KnownAgent agent) {
    return agents.session(agent.name()).map(AgentSession::refuses).orElse(agent.refuses());
  }

  private static String offline(int count) {
    return count <= 0 ? "" : "; " + agentsAre(count, "offline");
  }

  private static String agentsAre(long count, String what) {
    return count == 1 ? "1 agent is " + what : count + " agents are " + what;
  }
}
