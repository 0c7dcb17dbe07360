package org.sitaf.server.build;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.result.live.LiveCases;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Service;
import org.springframework.transaction.annotation.Transactional;

/**
 * Leases of attempts: creates attempts, renews their leases, and abandons them when their agent is
 * lost. Each change locks the build first.
 */
@Service
@Transactional
public class Leases {
  private final BuildRepository builds;
  private final AttemptRepository attempts;
  private final BuildQueue queue;
  private final RetryPolicy retryPolicy;
  private final LiveCases live;
  private final AnalysisQueue analyses;
  private final JdbcClient jdbc;
  private final ApplicationEventPublisher events;
  private final SitafSettings settings;
  private final Clock clock;

  Leases(
      BuildRepository builds,
      AttemptRepository attempts,
      BuildQueue queue,
      RetryPolicy retryPolicy,
      LiveCases live,
      AnalysisQueue analyses,
      JdbcClient jdbc,
      ApplicationEventPublisher events,
      SitafSettings settings,
      Clock clock) {
    this.builds = builds;
    this.attempts = attempts;
    this.queue = queue;
    this.retryPolicy = retryPolicy;
    this.live = live;
    this.analyses = analyses;
    this.jdbc = jdbc;
    this.events = events;
    this.settings = settings;
    this.clock = clock;
  }

  /**
   * The assignment of an attempt to an agent.
   *
   * @param kind what the agent does with the application
   * @param cases number of cases, or the maximum number of further cases of an analysis
   * @param activity name of the activity
   * @param devices the real devices that the build has alone
   * @param recordingBytes maximum total size of the recordings
   * @param signalBytes maximum total size of the signals
   */
  public record Assignment(
      AttemptKey key,
      BuildKind kind,
      int cases,
      String activity,
      String model,
      String language,
      List<StoredFile> files,
      Set<String> devices,
      RecordedCases recordedCases,
      long recordingBytes,
      long signalBytes) {}

  /** Assigns a build to an agent; empty if it is no longer queued. */
  public Optional<Assignment> lease(String buildId, String agent) {
    if (!queue.claim(buildId)) {
      return Optional.empty();
    }
    Build build = builds.findForUpdate(buildId).orElseThrow();
    Instant now = now();
    long logStart =
        jdbc.sql("SELECT log_length FROM build WHERE id = ?")
            .param(buildId)
            .query(Long.class)
            .single();
    int no = build.attempt() + 1;
    Attempt attempt =
        attempts.saveAndFlush(
            new Attempt(buildId, no, agent, now, now.plus(settings.lease()), logStart));
    build.lease(no, agent, now);
    live.delete(buildId);
    events.publishEvent(BuildEvent.Changed.of(build));
    return Optional.of(
        new Assignment(
            attempt.key(),
            build.kind(),
            build.casesTotal(),
            build.activityName(),
            build.model(),
            build.language(),
            analyses.filesOf(build),
            build.requirements().devices(),
            build.recordedCases(),
            settings.maxRecordings().toBytes(),
            settings.maxSignals().toBytes()));
  }

  /** Renews the leases of an agent's attempts; returns the attempts that the agent must stop. */
  public Set<AttemptKey> renew(String agent, Collection<AttemptKey> running) {
    if (running.isEmpty()) {
      return Set.of();
    }
    Set<Long> valid =
        Set.copyOf(attempts.findRunning(agent, running.stream().map(AttemptKey::token).toList()));
    if (!valid.isEmpty()) {
      attempts.renew(valid, now().plus(settings.lease()));
    }
    return running.stream()
        .filter(key -> !valid.contains(key.token()))
        .collect(Collectors.toUnmodifiableSet());
  }

  /** The real devices that the builds of attempts use, by token of the attempt. */
  @Transactional(readOnly = true)
  public Map<Long, Set<String>> devices(Collection<AttemptKey> running) {
    Map<Long, Set<String>> devices = new HashMap<>();
    running.forEach(
        key ->
            builds
                .findById(key.buildId())
                .ifPresent(build -> devices.put(key.token(), build.requirements().devices())));
    return devices;
  }

  /** Renews all leases, because agents could not do so while the server was down. */
  public int renewAll() {
    return attempts.renewAll(now().plus(settings.lease()));
  }

  /** Attempts whose lease has expired. */
  @Transactional(readOnly = true)
  public List<AttemptKey> overdue() {
    return attempts.findOverdue(now());
  }

  /** When the next lease expires. */
  @Transactional(readOnly = true)
  public Optional<Instant> nextDeadline() {
    return attempts.findNextDeadline();
  }

  /** Abandons an attempt whose lease has expired, unless it was renewed in the meantime. */
  public void expire(AttemptKey key) {
    Optional<Build> build = builds.findForUpdate(key.buildId());
    Optional<Attempt> attempt = attempts.findById(key.token());
    if (build.isPresent() && attempt.isPresent() && attempt.get().isOverdue(now())) {
      abandon(
          build.get(),
          attempt.get(),
          "agent "
              + attempt.get().agent()
              + " sent nothing for "
              + settings.lease().toSeconds()
              + " s");
    }
  }

  /**
   * Abandons the attempts that an agent no longer knows, because it was restarted.
   *
   * @param running the attempts that it reports
   */
  public void abandonAllExcept(String agent, Collection<AttemptKey> running) {
    Set<Long> kept = running.stream().map(AttemptKey::token).collect(Collectors.toSet());
    for (AttemptKey key : attempts.findRunningOf(agent)) {
      if (!kept.contains(key.token())) {
        abandon(key, "agent " + agent + " was restarted");
      }
    }
  }

  /** Abandons all attempts of an agent. */
  public void abandonAll(String agent, String why) {
    attempts.findRunningOf(agent).forEach(key -> abandon(key, why));
  }

  /** Returns which of the attempts have ended. */
  @Transactional(readOnly = true)
  public Set<Long> ended(Collection<Long> tokens) {
    return tokens.isEmpty() ? Set.of() : Set.copyOf(attempts.findEnded(tokens));
  }

  /** Abandons an attempt. */
  public void abandon(AttemptKey key, String why) {
    Optional<Build> build = builds.findForUpdate(key.buildId());
    Optional<Attempt> attempt = attempts.findById(key.token());
    if (build.isPresent() && attempt.isPresent() && !attempt.get().isOver()) {
      abandon(build.get(), attempt.get(), why);
    }
  }

  private void abandon(Build build, Attempt attempt, String why) {
    attempt.end(BuildState.FAILED, now());
    events.publishEvent(new BuildEvent.Stopped(attempt.key(), attempt.agent(), why, true));
    retryPolicy.afterLoss(build, why);
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
