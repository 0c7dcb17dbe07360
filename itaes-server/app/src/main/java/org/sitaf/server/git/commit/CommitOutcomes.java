package org.sitaf.server.git.commit;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.build.BuildEvent;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.comparison.Comparisons;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Service;
import org.springframework.transaction.event.TransactionalEventListener;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * Ends commits whose builds have ended, and compares them with the commits before. A periodic check
 * finds what a server that died has left.
 */
@Service
public class CommitOutcomes implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(CommitOutcomes.class);
  private static final int CHECK_S = 5;

  private final CommitRows commits;
  private final Comparisons comparisons;
  private final TransactionTemplate transaction;
  private final ApplicationEventPublisher events;
  private final DiskSpace disk;
  private ScheduledExecutorService thread = DaemonTimer.named("git-outcomes");
  private volatile boolean running;

  CommitOutcomes(
      CommitRows commits,
      Comparisons comparisons,
      TransactionTemplate transaction,
      ApplicationEventPublisher events,
      DiskSpace disk) {
    this.commits = commits;
    this.comparisons = comparisons;
    this.transaction = transaction;
    this.events = events;
    this.disk = disk;
  }

  @TransactionalEventListener
  void on(BuildEvent.Changed change) {
    if (running && change.state().isOver() && change.parentId() == null) {
      thread.execute(
          () -> {
            if (!commits.ofBuild(change.buildId()).isEmpty()) {
              check();
            }
          });
    }
  }

  @TransactionalEventListener
  void on(CommitEvent.Started started) {
    if (running) {
      // All its results may have been taken over.
      thread.execute(this::check);
    }
  }

  private void check() {
    if (!disk.canWrite()) {
      return;
    }
    try {
      boolean changed = true;
      // The end of a commit can be what the next one waits for.
      while (changed && running) {
        changed = false;
        for (String id : commits.ended()) {
          changed |= end(id);
        }
      }
    } catch (RuntimeException e) {
      if (running) {
        log.error("Check for commits whose builds have ended failed", e);
      }
    }
  }

  private boolean end(String id) {
    GitCommit commit = commits.find(id).orElse(null);
    if (commit == null) {
      return false;
    }
    Optional<GitCommit> base = base(commit);
    if (base.isPresent() && base.get().state() != GitCommit.State.DONE) {
      return false;
    }
    base.ifPresent(earlier -> compare(commit, earlier));
    return Boolean.TRUE.equals(
        transaction.execute(
            status -> {
              boolean moved =
                  commits.move(id, GitCommit.State.BUILDING, GitCommit.State.DONE, null);
              if (moved) {
                events.publishEvent(new CommitEvent.Ended(id));
              }
              return moved;
            }));
  }

  /** The nearest earlier commit that could be built. */
  public Optional<GitCommit> base(GitCommit commit) {
    GitCommit found = commit;
    do {
      String baseId = found.baseId();
      found = baseId == null ? null : commits.find(baseId).orElse(null);
    } while (found != null
        && (found.state() == GitCommit.State.INVALID || found.state() == GitCommit.State.SKIPPED));
    return Optional.ofNullable(found);
  }

  private void compare(GitCommit commit, GitCommit base) {
    Map<String, GitCell> before =
        commits.cells(base.id()).stream()
            .collect(Collectors.toMap(GitCell::model, Function.identity()));
    for (GitCell cell : commits.cells(commit.id())) {
      GitCell earlier = before.get(cell.model());
      if (earlier == null || cell.total() == null || earlier.total() == null) {
        continue;
      }
      if (earlier.buildId().equals(cell.buildId())) {
        commits.compared(commit.id(), cell.model(), cell.total(), 0);
      } else if (cell.state() == BuildState.DONE && earlier.state() == BuildState.DONE) {
        compare(commit, earlier, cell);
      }
    }
  }

  private void compare(GitCommit commit, GitCell earlier, GitCell cell) {
    try {
      Comparisons.Differences found = comparisons.differences(earlier.buildId(), cell.buildId());
      commits.compared(commit.id(), cell.model(), found.cases(), found.differingCases());
    } catch (RequestException | InvalidInputException | ComputationTimeoutException e) {
      log.debug("Build {} cannot be compared with {}", cell.buildId(), earlier.buildId(), e);
    }
  }

  @Override
  public void start() {
    if (thread.isShutdown()) {
      thread = DaemonTimer.named("git-outcomes");
    }
    running = true;
    var unused = thread.scheduleWithFixedDelay(this::check, 1, CHECK_S, TimeUnit.SECONDS);
  }

  @Override
  public void stop() {
    running = false;
    thread.shutdownNow();
  }

  @Override
  public boolean isRunning() {
    return running;
  }
}
