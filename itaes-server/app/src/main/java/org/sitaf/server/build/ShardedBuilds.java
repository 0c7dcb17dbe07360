package org.sitaf.server.build;

import java.io.ByteArrayOutputStream;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.result.Results;
import org.sitaf.server.result.live.LiveCases;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.timer.DaemonTimer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.context.SmartLifecycle;
import org.springframework.stereotype.Component;
import org.springframework.transaction.event.TransactionalEventListener;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * Updates builds with shards when their shards change. This happens in separate transactions after
 * those of the shards, so that no transaction waits for a build's row while it holds another one. A
 * periodic check finds what a server that died has left.
 */
@Component
class ShardedBuilds implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(ShardedBuilds.class);
  private static final Duration CHECK_INTERVAL = Duration.ofSeconds(10);

  private final BuildRepository repository;
  private final Builds builds;
  private final StoredFiles contents;
  private final Results results;
  private final LiveCases live;
  private final AnalysisQueue analyses;
  private final TransactionTemplate transaction;
  private final ApplicationEventPublisher events;
  private final DiskSpace disk;
  private final Clock clock;
  private ScheduledExecutorService thread = DaemonTimer.named("sharded-builds");
  private volatile boolean running;

  ShardedBuilds(
      BuildRepository repository,
      Builds builds,
      StoredFiles contents,
      Results results,
      LiveCases live,
      AnalysisQueue analyses,
      TransactionTemplate transaction,
      ApplicationEventPublisher events,
      DiskSpace disk,
      Clock clock) {
    this.repository = repository;
    this.builds = builds;
    this.contents = contents;
    this.results = results;
    this.live = live;
    this.analyses = analyses;
    this.transaction = transaction;
    this.events = events;
    this.disk = disk;
    this.clock = clock;
  }

  @TransactionalEventListener
  void on(BuildEvent.Changed change) {
    String parent = change.parentId();
    if (running && parent != null) {
      thread.execute(() -> update(parent));
    } else if (running && change.state().isOver()) {
      thread.execute(() -> cancelShards(change.buildId()));
    }
  }

  /** Handles builds whose events were lost because a server died or a transaction failed. */
  void check() {
    if (!disk.canWrite()) {
      return;
    }
    try {
      repository.findUnfinishedWithShards().forEach(this::update);
      repository.findEndedWithUnfinishedShards().forEach(this::cancelShards);
    } catch (RuntimeException e) {
      log.error("Check for builds whose shards have ended failed", e);
    }
  }

  private void update(String parentId) {
    try {
      transaction.executeWithoutResult(
          status ->
              repository
                  .findForUpdate(parentId)
                  .filter(parent -> !parent.state().isOver())
                  .ifPresent(
                      parent -> update(parent, repository.findByParentIdOrderByShard(parentId))));
    } catch (RuntimeException e) {
      if (running) {
        log.error("Update of build {} from its shards failed", parentId, e);
      }
    }
  }

  private void update(Build parent, List<Build> shards) {
    Instant now = now();
    Optional<Build> ended =
        shards.stream()
            .filter(p -> p.state() == BuildState.FAILED || p.state() == BuildState.CANCELLED)
            .findFirst();
    if (ended.isPresent()) {
      end(parent, ended.get(), now);
    } else if (shards.stream().allMatch(p -> p.state() == BuildState.DONE)) {
      complete(parent, shards, now);
    } else if (shards.stream().anyMatch(p -> p.state() != BuildState.QUEUED)) {
      parent.updateFromShards(shards.stream().mapToInt(Build::casesDone).sum(), now);
    } else {
      return;
    }
    if (parent.state().isOver()) {
      events.publishEvent(
          new BuildEvent.ShardsEnded(parent.id(), shards.stream().map(Build::id).toList()));
    }
    events.publishEvent(BuildEvent.Changed.of(parent));
  }

  private static void end(Build parent, Build shard, Instant now) {
    String which = "shard " + shard.shard() + " of " + parent.shards();
    if (shard.state() == BuildState.CANCELLED) {
      parent.cancel(which + " was cancelled", now);
    } else {
      BuildFailure failure = shard.failure().orElseThrow();
      parent.fail(
          new BuildFailure(
              failure.category(), which + ": " + failure.message(), failure.problems()),
          now);
    }
  }

  private void complete(Build parent, List<Build> shards, Instant now) {
    TestApplication application = TestApplication.read(contents.load(parent.files()));
    List<TestResult> shardResults =
        shards.stream().map(p -> Results.read(results.document(p.id()))).toList();
    TestResult joined = Shards.join(application, shardResults);
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    TestResultXml.write(joined, document);
    byte[] bytes = document.toByteArray();
    parent.updateFromShards(joined.cases().size(), now);
    results.accept(parent.id(), joined, bytes, StoredFiles.sha256(bytes), now);
    parent.complete(joined, now);
    analyses.explainIfRequested(parent);
    live.delete(parent.id());
  }

  /**
   * Cancels the remaining shards of a build that has ended. A shard that cannot be cancelled now,
   * such as because its row is locked, does not prevent cancelling the others; {@link #check}
   * retries it.
   */
  private void cancelShards(String parentId) {
    List<Build> shards =
        Optional.ofNullable(
                transaction.execute(status -> repository.findByParentIdOrderByShard(parentId)))
            .orElse(List.of());
    for (Build shard : shards) {
      if (!shard.state().isOver()) {
        cancel(shard);
      }
    }
  }

  private void cancel(Build shard) {
    try {
      builds.cancel(shard.id(), "its build has ended");
    } catch (RequestException e) {
      log.debug("Shard {} has ended already", shard.id(), e);
    } catch (RuntimeException e) {
      if (running) {
        log.warn(
            "Shard {} of an ended build could not be cancelled; retrying later", shard.id(), e);
      }
    }
  }

  @Override
  public void start() {
    if (thread.isShutdown()) {
      thread = DaemonTimer.named("sharded-builds");
    }
    running = true;
    var unused =
        thread.scheduleWithFixedDelay(
            this::check, 0, CHECK_INTERVAL.toMillis(), TimeUnit.MILLISECONDS);
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

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
