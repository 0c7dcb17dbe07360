package org.sitaf.server.build.agent;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.build.BuildQueue;
import org.sitaf.server.build.BuildQueue.QueuedBuild;
import org.sitaf.server.build.Leases;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.settings.Database;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.storage.DiskSpaceRecovered;
import org.sitaf.server.timer.DaemonTimer;
import org.sitaf.server.timer.WakeUp;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.SmartLifecycle;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Component;
import org.springframework.transaction.event.TransactionalEventListener;

/**
 * Assigns queued builds to agents that meet their requirements. Builds are ordered by priority,
 * then by the number of running builds of their activity, then by age. Runs when something changes,
 * when the delay of a build ends, and periodically if other servers share the database.
 */
@Component
class Dispatcher implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(Dispatcher.class);
  private static final int MAX_WINDOW = 200;
  private static final Duration SHARED_INTERVAL = Duration.ofMillis(300);

  private final Leases leases;
  private final BuildQueue queue;
  private final Agents agents;
  private final Database database;
  private final DiskSpace disk;
  private final Clock clock;
  private final AtomicBoolean due = new AtomicBoolean();
  private volatile boolean running;
  private ScheduledExecutorService thread = DaemonTimer.named("dispatcher");
  private WakeUp whenADelayEnds = new WakeUp(thread, this::wake);

  Dispatcher(
      Leases leases,
      BuildQueue queue,
      Agents agents,
      Database database,
      DiskSpace disk,
      Clock clock) {
    this.leases = leases;
    this.queue = queue;
    this.agents = agents;
    this.database = database;
    this.disk = disk;
    this.clock = clock;
  }

  /** Runs the dispatcher soon; several calls may be merged into one run. */
  void wake() {
    if (running && due.compareAndSet(false, true)) {
      thread.execute(this::dispatch);
    }
  }

  /** Releases slots before it dispatches: otherwise a free slot could be noticed by nobody. */
  @TransactionalEventListener
  void on(BuildEvent event) {
    if (event instanceof BuildEvent.Delivered delivered) {
      agents.delivered(delivered);
    } else if (event instanceof BuildEvent.Stopped stopped) {
      agents.stopped(stopped);
    }
    wake();
  }

  @EventListener
  void on(DiskSpaceRecovered event) {
    wake();
  }

  private void dispatch() {
    due.set(false);
    try {
      if (disk.whyNoNewWork().isPresent()) {
        return;
      }
      Instant now = clock.instant();
      List<AgentSession> free = freeAgents();
      List<Requirements> met =
          free.isEmpty()
              ? List.of()
              : queue.requirements(now).stream()
                  .filter(r -> free.stream().anyMatch(a -> canRun(a, r)))
                  .toList();
      if (!met.isEmpty()) {
        int slots = free.stream().mapToInt(AgentSession::freeSlots).sum();
        List<QueuedBuild> waiting =
            new ArrayList<>(queue.first(met, Math.min(Math.max(slots, 1), MAX_WINDOW), now));
        assign(waiting, free, queue.active());
      }
      queue.nextDelayEnd(now).ifPresent(when -> whenADelayEnds.at(when, clock.instant()));
    } catch (RuntimeException e) {
      // The builds are dispatched with the next change.
      if (running) {
        log.error("Dispatching builds failed", e);
      }
    }
  }

  private List<AgentSession> freeAgents() {
    List<AgentSession> able =
        agents.connected().stream().filter(AgentSession::hasFreeSlot).toList();
    if (able.isEmpty()) {
      return able;
    }
    Set<String> inactive = agents.inactive();
    return able.stream().filter(a -> !inactive.contains(a.name())).toList();
  }

  private void assign(
      List<QueuedBuild> waiting, List<AgentSession> free, Map<String, Integer> active) {
    Comparator<QueuedBuild> order =
        Comparator.comparingInt((QueuedBuild w) -> -w.priority())
            .thenComparingInt(w -> active.getOrDefault(w.activityId(), 0))
            .thenComparing(QueuedBuild::created)
            .thenComparing(QueuedBuild::id);
    while (running && !waiting.isEmpty()) {
      QueuedBuild next = waiting.stream().min(order).orElseThrow();
      waiting.remove(next);
      Optional<AgentSession> agent =
          free.stream()
              .filter(a -> a.hasFreeSlot() && canRun(a, next.requirements()))
              .min(Comparator.comparingInt(AgentSession::busy));
      if (agent.isPresent() && assign(next.id(), agent.get())) {
        active.merge(next.activityId(), 1, Integer::sum);
      } else if (agent.isEmpty()) {
        waiting.removeIf(w -> w.requirements().equals(next.requirements()));
        // Those that wait for a real device may have kept others out of the list.
        if (!next.requirements().devices().isEmpty()
            && free.stream().anyMatch(AgentSession::hasFreeSlot)) {
          wake();
        }
      }
    }
  }

  private static boolean canRun(AgentSession agent, Requirements requirements) {
    return requirements.areMetBy(agent.offers()) && agent.hasFree(requirements.devices());
  }

  private boolean assign(String buildId, AgentSession agent) {
    Optional<Leases.Assignment> assignment = leases.lease(buildId, agent.name());
    assignment.ifPresent(leased -> send(agent, leased));
    return assignment.isPresent();
  }

  private void send(AgentSession agent, Leases.Assignment assignment) {
    agent.occupy(assignment.key(), assignment.devices());
    boolean sent =
        agent.send(
            ServerMessage.newBuilder().setAssignment(Messages.toAssignment(assignment)).build());
    if (sent) {
      log.info(
          "Build {} ({}/{}) assigned to agent {}",
          assignment.key().buildId(),
          assignment.activity(),
          assignment.model(),
          agent.name());
    } else {
      leases.abandon(assignment.key(), "agent " + agent.name() + " disconnected");
    }
  }

  @Override
  public void start() {
    if (thread.isShutdown()) {
      thread = DaemonTimer.named("dispatcher");
      whenADelayEnds = new WakeUp(thread, this::wake);
    }
    running = true;
    wake();
    if (database.isShared()) {
      long intervalMs = SHARED_INTERVAL.toMillis();
      var unused =
          thread.scheduleWithFixedDelay(this::wake, intervalMs, intervalMs, TimeUnit.MILLISECONDS);
    }
  }

  @Override
  public void stop() {
    running = false;
    thread.shutdownNow();
    agents.closeAll();
  }

  @Override
  public boolean isRunning() {
    return running;
  }
}
