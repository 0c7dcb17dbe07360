package org.sitaf.server.build.agent;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.build.BuildEvent;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Component;
import org.springframework.transaction.event.TransactionalEventListener;

/**
 * Gives waiting builds to agents that can execute them, the oldest first. Works when something has
 * changed, and sleeps otherwise.
 */
@Component
public class Dispatcher implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(Dispatcher.class);

  private final Attempts attempts;
  private final Agents agents;
  private final AtomicBoolean due = new AtomicBoolean();
  private volatile boolean running;
  private ExecutorService thread = newThread();

  Dispatcher(Attempts attempts, Agents agents) {
    this.attempts = attempts;
    this.agents = agents;
  }

  /** Has the queue looked at, soon and once for many calls. */
  void wake() {
    if (running && due.compareAndSet(false, true)) {
      thread.execute(this::dispatch);
    }
  }

  /** Why a build of that language waits, for people. */
  public String whyWaiting(String language) {
    List<AgentSession> connected = List.copyOf(agents.connected());
    int offline = agents.all().size() - connected.size();
    String others = offline <= 0 ? "" : "; " + agentsAre(offline, "offline");
    long able = connected.stream().filter(a -> a.offers(language)).count();
    if (connected.isEmpty()) {
      return "no agent is connected" + others;
    }
    if (able == 0) {
      return "no agent offers " + language + others;
    }
    boolean free = connected.stream().anyMatch(a -> a.offers(language) && a.hasFreeSlot());
    return free
        ? "about to be given to an agent"
        : agentsAre(able, "busy with other builds") + others;
  }

  @TransactionalEventListener
  void on(BuildEvent event) {
    wake();
  }

  private void dispatch() {
    due.set(false);
    try {
      List<String> languages =
          agents.connected().stream()
              .filter(AgentSession::hasFreeSlot)
              .flatMap(a -> a.languages().stream())
              .distinct()
              .toList();
      for (String buildId : attempts.waiting(languages)) {
        attempts.languageOf(buildId).ifPresent(language -> give(buildId, language));
      }
    } catch (RuntimeException e) {
      // A build that could not be given now is looked at again with the next change.
      if (running) {
        log.error("Dispatching failed", e);
      }
    }
  }

  private void give(String buildId, String language) {
    Optional<AgentSession> free =
        agents.connected().stream()
            .filter(a -> a.offers(language) && a.hasFreeSlot())
            .min(java.util.Comparator.comparingInt(AgentSession::busy));
    free.flatMap(agent -> attempts.lease(buildId, agent.name()))
        .ifPresent(assignment -> send(free.orElseThrow(), assignment));
  }

  private void send(AgentSession agent, Attempts.Assignment assignment) {
    agent.occupy(assignment.key());
    boolean sent =
        agent.send(
            ServerMessage.newBuilder().setAssignment(Messages.toAssignment(assignment)).build());
    if (sent) {
      log.info(
          "Build {} ({}/{}) goes to agent {}",
          assignment.key().buildId(),
          assignment.activity(),
          assignment.model(),
          agent.name());
    } else {
      attempts.giveUp(assignment.key(), "agent " + agent.name() + " went away");
    }
  }

  @Override
  public void start() {
    if (thread.isShutdown()) {
      thread = newThread();
    }
    running = true;
    wake();
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

  private static String agentsAre(long count, String what) {
    return count == 1 ? "1 agent is " + what : count + " agents are " + what;
  }

  private static ExecutorService newThread() {
    return Executors.newSingleThreadExecutor(
        task -> {
          Thread made = new Thread(task, "dispatcher");
          made.setDaemon(true);
          return made;
        });
  }
}
