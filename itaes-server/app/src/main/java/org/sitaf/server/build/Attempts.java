package org.sitaf.server.build;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.result.Results;
import org.sitaf.server.result.live.LiveCases;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Transactional;

/**
 * Processes what agents report about their attempts. A build is executed at least once, and exactly
 * one result is accepted: each change first locks the build and then checks the fencing token.
 */
@Service
@Transactional
public class Attempts {
  private final BuildRepository builds;
  private final AttemptRepository attempts;
  private final Results results;
  private final StoredFiles contents;
  private final AnalysisQueue analyses;
  private final AnalysisReports reports;
  private final LiveCases live;
  private final RetryPolicy retryPolicy;
  private final ApplicationEventPublisher events;
  private final Clock clock;

  Attempts(
      BuildRepository builds,
      AttemptRepository attempts,
      Results results,
      StoredFiles contents,
      AnalysisQueue analyses,
      AnalysisReports reports,
      LiveCases live,
      RetryPolicy retryPolicy,
      ApplicationEventPublisher events,
      Clock clock) {
    this.builds = builds;
    this.attempts = attempts;
    this.results = results;
    this.contents = contents;
    this.analyses = analyses;
    this.reports = reports;
    this.live = live;
    this.retryPolicy = retryPolicy;
    this.events = events;
    this.clock = clock;
  }

  /** What happened to a delivered result. */
  public enum Delivery {
    /** The result is stored as the build's result. */
    ACCEPTED,
    /** The result of another attempt was accepted before. */
    SUPERSEDED,
    /** The attempt was abandoned or cancelled, and the build has no result yet. */
    ABANDONED
  }

  /** The attempts of a build, oldest first. */
  @Transactional(readOnly = true)
  public List<AttemptSummary> of(String buildId) {
    if (builds.findById(buildId).isEmpty()) {
      throw RequestException.notFound("build", buildId);
    }
    return attempts.findByBuildIdOrderByNo(buildId).stream().map(Attempt::summary).toList();
  }

  /** Stores the state that the agent reports. */
  public void advance(AttemptKey key, BuildState state) {
    Build build = lock(key);
    Attempt attempt = findRunning(key);
    attempt.advance(state);
    build.advance(state, now());
    changed(build);
  }

  /**
   * Stores finished cases for the live view.
   *
   * @param batch number of the batch in the attempt, from 1; a known batch is ignored; 0 is not
   *     numbered
   * @return the next expected batch
   */
  public long addCases(AttemptKey key, long batch, Collection<CaseResult> ended) {
    Build build = lock(key);
    Attempt attempt = findRunning(key);
    if (attempt.acceptBatch(batch)) {
      Set<Integer> added = build.addCases(ended.stream().map(CaseResult::no).toList());
      live.append(build.id(), ended.stream().filter(c -> added.contains(c.no())).toList());
      changed(build);
    }
    return attempt.nextBatch();
  }

  /** The agent of an attempt; empty if there is no such attempt. */
  @Transactional(readOnly = true)
  public Optional<String> agentOf(AttemptKey key) {
    return attempts
        .findById(key.token())
        .filter(attempt -> attempt.key().equals(key))
        .map(Attempt::agent);
  }

  /** Offset of a running attempt's log in the build's log, in bytes. */
  @Transactional(readOnly = true)
  public long logStartOfRunning(AttemptKey key) {
    return findRunning(key).logStart();
  }

  /** Offset of an attempt's log in the build's log, in bytes. */
  @Transactional(readOnly = true)
  public long logStart(AttemptKey key) {
    return find(key).logStart();
  }

  /**
   * The content of a file of a running attempt's build, or of the result that it explains; agents
   * can only download these files.
   */
  @Transactional(readOnly = true)
  public byte[] content(AttemptKey key, String sha256) {
    findRunning(key);
    Build build = builds.findById(key.buildId()).orElseThrow(() -> buildNotFound(key));
    Optional<String> analysed = build.analysedId().filter(id -> results.sha256(id).equals(sha256));
    return analysed.isPresent()
        ? results.document(analysed.get())
        : contents.content(file(key, sha256).sha256());
  }

  /** A file of a running attempt's build. */
  @Transactional(readOnly = true)
  StoredFile file(AttemptKey key, String sha256) {
    findRunning(key);
    return builds.findById(key.buildId()).orElseThrow(() -> buildNotFound(key)).files().stream()
        .filter(file -> file.sha256().equals(sha256))
        .findFirst()
        .orElseThrow(() -> RequestException.notFound("file in build " + key.buildId(), sha256));
  }

  /**
   * Accepts the result of a running attempt. Repeating the call changes nothing.
   *
   * @throws OutdatedAttemptException if there is no such attempt
   */
  public Delivery deliver(AttemptKey key, TestResult result, byte[] document, String sha256) {
    Build build = lock(key);
    Attempt attempt = find(key);
    if (attempt.delivered(sha256)) {
      return Delivery.ACCEPTED;
    }
    if (attempt.isOver()) {
      return storeLateResult(build, attempt, document);
    }
    if (build.kind() != BuildKind.TEST) {
      throw RequestException.malformed("The build is an analysis, so its outcome has no cases.");
    }
    if (result.cases().size() > build.casesTotal()) {
      throw RequestException.malformed(
          "The result has "
              + result.cases().size()
              + " cases, but the suite only "
              + build.casesTotal()
              + ".");
    }
    Instant now = now();
    results.accept(key.buildId(), result, document, sha256, now);
    attempt.endWithResult(sha256, now);
    build.complete(result, now);
    if (build.parentId().isEmpty()) {
      analyses.explainIfRequested(build);
    }
    if (build.parentId().isEmpty()) {
      // The cases of a shard are still shown as those of the whole build.
      live.delete(build.id());
    }
    events.publishEvent(new BuildEvent.Delivered(key, attempt.agent()));
    changed(build);
    return Delivery.ACCEPTED;
  }

  /**
   * Accepts the report of a running analysis. Repeating the call changes nothing.
   *
   * @param document the report as JSON
   * @param sha256 of what the agent sent
   * @throws OutdatedAttemptException if there is no such attempt
   */
  public Delivery deliverAnalysis(AttemptKey key, BuildKind kind, byte[] document, String sha256) {
    Build build = lock(key);
    Attempt attempt = find(key);
    if (attempt.delivered(sha256)) {
      return Delivery.ACCEPTED;
    }
    if (attempt.isOver()) {
      events.publishEvent(new BuildEvent.Delivered(attempt.key(), attempt.agent()));
      return build.state() == BuildState.DONE ? Delivery.SUPERSEDED : Delivery.ABANDONED;
    }
    if (build.kind() != kind) {
      throw RequestException.malformed(
          "The outcome is of the kind "
              + kind
              + ", but the build is of the kind "
              + build.kind()
              + ".");
    }
    Instant now = now();
    reports.insert(build.id(), document);
    attempt.endWithResult(sha256, now);
    build.completeAnalysis(now);
    live.delete(build.id());
    events.publishEvent(new BuildEvent.Delivered(key, attempt.agent()));
    changed(build);
    return Delivery.ACCEPTED;
  }

  /** Ends a running attempt without a result. Repeating the call changes nothing. */
  public void fail(AttemptKey key, BuildFailure failure) {
    Build build = lock(key);
    Attempt attempt = find(key);
    if (attempt.state() == BuildState.FAILED) {
      return;
    }
    requireRunning(attempt);
    attempt.end(BuildState.FAILED, now());
    events.publishEvent(new BuildEvent.Delivered(key, attempt.agent()));
    retryPolicy.afterFailure(build, failure);
  }

  /** The agent stopped a cancelled attempt, or cancelled it by itself. */
  public void cancelled(AttemptKey key, String message) {
    Build build = lock(key);
    Attempt attempt = find(key);
    events.publishEvent(new BuildEvent.Delivered(key, attempt.agent()));
    if (attempt.isOver()) {
      return;
    }
    attempt.end(BuildState.CANCELLED, now());
    build.cancel(message, now());
    changed(build);
  }

  /** Stores the result of an attempt that has ended before; it does not count. */
  private Delivery storeLateResult(Build build, Attempt attempt, byte[] document) {
    if (attempt.state() == BuildState.FAILED) {
      results.storeSuperseded(attempt.key().token(), document, now());
      attempt.supersede();
    }
    events.publishEvent(new BuildEvent.Delivered(attempt.key(), attempt.agent()));
    return build.state() == BuildState.DONE ? Delivery.SUPERSEDED : Delivery.ABANDONED;
  }

  private Build lock(AttemptKey key) {
    return builds.findForUpdate(key.buildId()).orElseThrow(() -> buildNotFound(key));
  }

  private Attempt findRunning(AttemptKey key) {
    Attempt attempt = find(key);
    requireRunning(attempt);
    return attempt;
  }

  private Attempt find(AttemptKey key) {
    Attempt attempt =
        attempts
            .findById(key.token())
            .orElseThrow(() -> new OutdatedAttemptException(key, "has another fencing token"));
    if (!attempt.key().equals(key)) {
      throw new OutdatedAttemptException(key, "has another fencing token");
    }
    return attempt;
  }

  private static void requireRunning(Attempt attempt) {
    if (attempt.isOver()) {
      throw new OutdatedAttemptException(attempt.key(), "has ended: " + attempt.state());
    }
  }

  private void changed(Build build) {
    events.publishEvent(BuildEvent.Changed.of(build));
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }

  private static RequestException buildNotFound(AttemptKey key) {
    return RequestException.notFound("build", key.buildId());
  }
}
