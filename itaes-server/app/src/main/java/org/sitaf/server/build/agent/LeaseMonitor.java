package org.sitaf.server.build.agent;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Leases;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.context.SmartLifecycle;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Component;

/**
 * Finds lost agents. The next check runs when the next lease can expire: at the earliest deadline,
 * but at most a third of a lease from now.
 */
@Component
class LeaseMonitor implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(LeaseMonitor.class);

  private final Leases leases;
  private final Agents agents;
  private final SitafSettings settings;
  private final DiskSpace disk;
  private final Clock clock;
  private ScheduledExecutorService timer = DaemonTimer.named("lease-watch");
  private volatile boolean running;
  private boolean diskWasFull;

  LeaseMonitor(Leases leases, Agents agents, SitafSettings settings, DiskSpace disk, Clock clock) {
    this.leases = leases;
    this.agents = agents;
    this.settings = settings;
    this.disk = disk;
    this.clock = clock;
  }

  private void check() {
    // Other servers have to see our agents within a lease.
    Instant next = clock.instant().plus(settings.lease().dividedBy(3));
    try {
      if (!disk.canWrite()) {
        diskWasFull = true;
        return;
      }
      if (diskWasFull) {
        // Leases could not be renewed in the meantime.
        leases.renewAll();
        diskWasFull = false;
      }
      agents.closeSilent();
      agents.saveConnected();
      for (AttemptKey key : leases.overdue()) {
        log.warn("Build {}: agent of attempt {} was lost", key.buildId(), key.no());
        leases.expire(key);
      }
      Instant deadline = leases.nextDeadline().orElse(next);
      next = deadline.isBefore(next) ? deadline : next;
      for (AgentSession session : agents.connected()) {
        Instant silentAt = session.lastHeartbeat().plus(settings.lease());
        next = silentAt.isBefore(next) ? silentAt : next;
      }
    } catch (RuntimeException e) {
      if (running) {
        log.error("Check for lost agents failed", e);
      }
    } finally {
      scheduleCheck(next);
    }
  }

  private void scheduleCheck(Instant when) {
    if (running) {
      long delayMs = Math.max(10, Duration.between(clock.instant(), when).toMillis() + 1);
      var unused = timer.schedule(this::check, delayMs, TimeUnit.MILLISECONDS);
    }
  }

  @Override
  public void start() {
    if (timer.isShutdown()) {
      timer = DaemonTimer.named("lease-watch");
    }
    running = true;
    leases.renewAll();
    timer.execute(this::check);
  }

  /** Startup may take longer than a lease, and leases cannot be renewed before it ends. */
  @EventListener
  void on(ApplicationReadyEvent ready) {
    leases.renewAll();
  }

  @Override
  public void stop() {
    running = false;
    timer.shutdownNow();
  }

  @Override
  public boolean isRunning() {
    return running;
  }
}
