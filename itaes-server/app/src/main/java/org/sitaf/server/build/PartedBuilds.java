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
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.refusal.Refusal;
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
 * Builds whose cases are spread over several agents. They follow their parts in transactions of
 * their own, after those of the parts: nobody ever waits for a part's row while holding another's.
 * What a server that died left undone, a look now and then finds.
 */
@Component
class PartedBuilds implements SmartLifecycle {
  private static final Logger log = LoggerFactory.getLogger(PartedBuilds.class);
  private static final Duration BETWEEN_LOOKS = Duration.ofSeconds(10);

  private final BuildRepository builds;
  private final Builds all;
  private final StoredFiles contents;
  private final Results results;
  private final LiveCases live;
  private final TransactionTemplate transaction;
  private final ApplicationEventPublisher events;
  private final DiskSpace disk;
  private final Clock clock;
  private ScheduledExecutorService thread = DaemonTimer.named("parted-builds");
  private volatile boolean running;

  PartedBuilds(
      BuildRepository builds,
      Builds all,
      StoredFiles contents,
      Results results,
      LiveCases live,
      TransactionTemplate transaction,
      ApplicationEventPublisher events,
      DiskSpace disk,
      Clock clock) {
    this.builds = builds;
    this.all = all;
    this.contents = contents;
    this.results = results;
    this.live = live;
    this.transaction = transaction;
    this.events = events;
    this.disk = disk;
    this.clock = clock;
  }

  @TransactionalEventListener
  void on(BuildEvent.Changed change) {
    String parent = change.parentId();
    if (running && parent != null) {
      thread.execute(() -> follow(parent));
    } else if (running && change.state().isOver()) {
      thread.execute(() -> cancelParts(change.buildId()));
    }
  }

  /** Completes what events did not: they are lost when a server dies or a transaction fails. */
  void look() {
    if (!disk.canWrite()) {
      return;
    }
    try {
      builds.findUnfinishedWithParts().forEach(this::follow);
      builds.findOverWithUnfinishedParts().forEach(this::cancelParts);
    } catch (RuntimeException e) {
      log.error("Looking for builds whose parts have ended failed", e);
    }
  }

  private void follow(String parentId) {
    try {
      transaction.executeWithoutResult(
          status ->
              builds
                  .findForChange(parentId)
                  .filter(parent -> !parent.state().isOver())
                  .ifPresent(parent -> follow(parent, builds.findByParentIdOrderByPart(parentId))));
    } catch (RuntimeException e) {
      if (running) {
        log.error("Build {} could not follow its parts", parentId, e);
      }
    }
  }

  private void follow(Build parent, List<Build> parts) {
    Instant now = now();
    Optional<Build> ended =
        parts.stream()
            .filter(p -> p.state() == BuildState.FAILED || p.state() == BuildState.CANCELLED)
            .findFirst();
    if (ended.isPresent()) {
      end(parent, ended.get(), now);
    } else if (parts.stream().allMatch(p -> p.state() == BuildState.DONE)) {
      complete(parent, parts, now);
    } else if (parts.stream().anyMatch(p -> p.state() != BuildState.QUEUED)) {
      parent.followParts(parts.stream().mapToInt(Build::casesDone).sum(), now);
    } else {
      return;
    }
    if (parent.state().isOver()) {
      events.publishEvent(
          new BuildEvent.PartsEnded(parent.id(), parts.stream().map(Build::id).toList()));
    }
    events.publishEvent(BuildEvent.Changed.of(parent));
  }

  private static void end(Build parent, Build part, Instant now) {
    String which = "shard " + part.part() + " of " + parent.parts();
    if (part.state() == BuildState.CANCELLED) {
      parent.cancel(which + " was cancelled", now);
    } else {
      BuildFailure failure = part.failure().orElseThrow();
      parent.fail(
          new BuildFailure(
              failure.category(), which + ": " + failure.message(), failure.problems()),
          now);
    }
  }

  private void complete(Build parent, List<Build> parts, Instant now) {
    TestApplication application = TestApplication.read(contents.load(parent.files()));
    List<TestResult> ofParts =
        parts.stream().map(p -> Results.read(results.document(p.id()))).toList();
    TestResult joined = Parts.join(application, ofParts);
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    TestResultXml.write(joined, document);
    byte[] bytes = document.toByteArray();
    parent.followParts(joined.cases().size(), now);
    results.accept(parent.id(), joined, bytes, StoredFiles.sha256(bytes), now);
    parent.complete(joined, now);
    live.forget(parent.id());
  }

  /**
   * Cancels the parts of a build that is over. A part that cannot be cancelled now, for example
   * because its row is locked, does not keep the others running; {@link #look} tries it again.
   */
  private void cancelParts(String parentId) {
    List<Build> parts =
        Optional.ofNullable(
                transaction.execute(status -> builds.findByParentIdOrderByPart(parentId)))
            .orElse(List.of());
    for (Build part : parts) {
      if (!part.state().isOver()) {
        cancel(part);
      }
    }
  }

  private void cancel(Build part) {
    try {
      all.cancel(part.id(), "its build is over");
    } catch (Refusal e) {
      log.debug("Part {} ended by itself", part.id(), e);
    } catch (RuntimeException e) {
      if (running) {
        log.warn("Part {} of a build that is over could not be cancelled yet", part.id(), e);
      }
    }
  }

  @Override
  public void start() {
    if (thread.isShutdown()) {
      thread = DaemonTimer.named("parted-builds");
    }
    running = true;
    var unused =
        thread.scheduleWithFixedDelay(
            this::look, 0, BETWEEN_LOOKS.toMillis(), TimeUnit.MILLISECONDS);
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
