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
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.result.Results;
import org.sitaf.server.result.live.LiveCases;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Transactional;

/**
 * Attempts at builds: what agents report of them, and how they end by themselves. A build is
 * executed at least once, and exactly one result of it is accepted: each change locks the build
 * first and looks at the fencing token then.
 */
@Service
@Transactional
public class Attempts {
  private final BuildRepository builds;
  private final AttemptRepository attempts;
  private final Results results;
  private final LiveCases live;
  private final Retries retries;
  private final ApplicationEventPublisher events;
  private final Clock clock;

  Attempts(
      BuildRepository builds,
      AttemptRepository attempts,
      Results results,
      LiveCases live,
      Retries retries,
      ApplicationEventPublisher events,
      Clock clock) {
    this.builds = builds;
    this.attempts = attempts;
    this.results = results;
    this.live = live;
    this.retries = retries;
    this.events = events;
    this.clock = clock;
  }

  /** What becomes of a result. */
  public enum Delivery {
    /** It is the build's result, and on disk. */
    ACCEPTED,
    /** Another attempt's result was accepted before. */
    SUPERSEDED,
    /** The attempt was given up or cancelled, and the build has no result yet. */
    GIVEN_UP
  }

  /** The attempts at a build, the first first. */
  @Transactional(readOnly = true)
  public List<PastAttempt> of(String buildId) {
    if (builds.findById(buildId).isEmpty()) {
      throw Refusal.notFound("build", buildId);
    }
    return attempts.findByBuildIdOrderByNo(buildId).stream().map(Attempt::view).toList();
  }

  /** Follows an agent from state to state. */
  public void advance(AttemptKey key, BuildState state) {
    Build build = lock(key);
    Attempt attempt = live(key);
    attempt.advance(state);
    build.advance(state, now());
    changed(build);
  }

  /**
   * Notes cases that have ended, and keeps them for those who watch.
   *
   * @param batch counts from 1 in an attempt; a batch that came before changes nothing; 0 does not
   *     count
   * @return the batch that is expected next
   */
  public long noteCases(AttemptKey key, long batch, Collection<CaseResult> ended) {
    Build build = lock(key);
    Attempt attempt = live(key);
    if (attempt.takesBatch(batch)) {
      Set<Integer> news = build.noteCases(ended.stream().map(CaseResult::no).toList());
      live.append(build.id(), ended.stream().filter(c -> news.contains(c.no())).toList());
      changed(build);
    }
    return attempt.nextBatch();
  }

  /** The agent to which the attempt was given; empty when there is no such attempt. */
  @Transactional(readOnly = true)
  public Optional<String> agentOf(AttemptKey key) {
    return attempts
        .findById(key.token())
        .filter(attempt -> attempt.key().equals(key))
        .map(Attempt::agent);
  }

  /** Where the log of a live attempt begins in the log of its build, in bytes. */
  @Transactional(readOnly = true)
  public long logStart(AttemptKey key) {
    return live(key).logStart();
  }

  /** Where the log of an attempt begins in the log of its build, in bytes. */
  @Transactional(readOnly = true)
  public long logBegin(AttemptKey key) {
    return known(key).logStart();
  }

  /**
   * The digest of a file of a live attempt's build, which makes sure that the agent may have it.
   */
  @Transactional(readOnly = true)
  public StoredFile file(AttemptKey key, String sha256) {
    live(key);
    return builds.findById(key.buildId()).orElseThrow(() -> noBuild(key)).files().stream()
        .filter(file -> file.sha256().equals(sha256))
        .findFirst()
        .orElseThrow(() -> Refusal.notFound("file in build " + key.buildId(), sha256));
  }

  /**
   * Accepts the result of a live attempt; accepting it again changes nothing.
   *
   * @throws OutdatedAttemptException when there never was such an attempt
   */
  public Delivery deliver(AttemptKey key, TestResult result, byte[] document, String sha256) {
    Build build = lock(key);
    Attempt attempt = known(key);
    if (attempt.delivered(sha256)) {
      return Delivery.ACCEPTED;
    }
    if (attempt.isOver()) {
      return keepLate(build, attempt, document);
    }
    if (result.cases().size() > build.casesTotal()) {
      throw Refusal.malformed(
          "The result has "
              + result.cases().size()
              + " cases, the suite "
              + build.casesTotal()
              + ".");
    }
    Instant now = now();
    results.accept(key.buildId(), result, document, sha256, now);
    attempt.endWithResult(sha256, now);
    build.complete(result, now);
    if (build.parentId().isEmpty()) {
      // Cases of a part are still looked at as those of the whole.
      live.forget(build.id());
    }
    events.publishEvent(new BuildEvent.Delivered(key, attempt.agent()));
    changed(build);
    return Delivery.ACCEPTED;
  }

  /** Ends a live attempt that has no result; saying it again changes nothing. */
  public void fail(AttemptKey key, BuildFailure failure) {
    Build build = lock(key);
    Attempt attempt = known(key);
    if (attempt.state() == BuildState.FAILED) {
      return;
    }
    requireLive(attempt);
    attempt.end(BuildState.FAILED, now());
    events.publishEvent(new BuildEvent.Delivered(key, attempt.agent()));
    retries.afterFailure(build, failure);
  }

  /**
   * An agent confirms that it has stopped a cancelled attempt, or has cancelled it of its own
   * accord.
   */
  public void cancelled(AttemptKey key, String message) {
    Build build = lock(key);
    Attempt attempt = known(key);
    events.publishEvent(new BuildEvent.Delivered(key, attempt.agent()));
    if (attempt.isOver()) {
      return;
    }
    attempt.end(BuildState.CANCELLED, now());
    build.cancel(message, now());
    changed(build);
  }

  /** A late result is kept for people; what counts is decided already. */
  private Delivery keepLate(Build build, Attempt attempt, byte[] document) {
    if (attempt.state() == BuildState.FAILED) {
      results.keepSuperseded(attempt.key().token(), document, now());
      attempt.supersede();
    }
    events.publishEvent(new BuildEvent.Delivered(attempt.key(), attempt.agent()));
    return build.state() == BuildState.DONE ? Delivery.SUPERSEDED : Delivery.GIVEN_UP;
  }

  private Build lock(AttemptKey key) {
    return builds.findForChange(key.buildId()).orElseThrow(() -> noBuild(key));
  }

  private Attempt live(AttemptKey key) {
    Attempt attempt = known(key);
    requireLive(attempt);
    return attempt;
  }

  private Attempt known(AttemptKey key) {
    Attempt attempt =
        attempts
            .findById(key.token())
            .orElseThrow(() -> new OutdatedAttemptException(key, "has another fencing token"));
    if (!attempt.key().equals(key)) {
      throw new OutdatedAttemptException(key, "has another fencing token");
    }
    return attempt;
  }

  private static void requireLive(Attempt attempt) {
    if (attempt.isOver()) {
      throw new OutdatedAttemptException(attempt.key(), "is over: " + attempt.state());
    }
  }

  private void changed(Build build) {
    events.publishEvent(BuildEvent.Changed.of(build));
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }

  private static Refusal noBuild(AttemptKey key) {
    return Refusal.notFound("build", key.buildId());
  }
}
