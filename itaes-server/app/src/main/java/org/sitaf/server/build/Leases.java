package org.sitaf.server.build;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collection;
import java.util.List;
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
 * Which agent holds which attempt, and until when unless it renews its lease: attempts begin here,
 * and here they end when their agent is lost. Whoever changes one locks its build first.
 */
@Service
@Transactional
public class Leases {
  private final BuildRepository builds;
  private final AttemptRepository attempts;
  private final BuildQueue queue;
  private final Retries retries;
  private final LiveCases live;
  private final JdbcClient jdbc;
  private final ApplicationEventPublisher events;
  private final SitafSettings settings;
  private final Clock clock;

  Leases(
      BuildRepository builds,
      AttemptRepository attempts,
      BuildQueue queue,
      Retries retries,
      LiveCases live,
      JdbcClient jdbc,
      ApplicationEventPublisher events,
      SitafSettings settings,
      Clock clock) {
    this.builds = builds;
    this.attempts = attempts;
    this.queue = queue;
    this.retries = retries;
    this.live = live;
    this.jdbc = jdbc;
    this.events = events;
    this.settings = settings;
    this.clock = clock;
  }

  /**
   * What an agent is given.
   *
   * @param activity name of the activity
   * @param recordingBytes at most, of all recordings together
   */
  public record Assignment(
      AttemptKey key,
      String activity,
      String model,
      String language,
      List<StoredFile> files,
      RecordedCases recordedCases,
      long recordingBytes) {}

  /** Gives a build to an agent; empty when it does not wait any more. */
  public Optional<Assignment> lease(String buildId, String agent) {
    if (!queue.claim(buildId)) {
      return Optional.empty();
    }
    Build build = builds.findForChange(buildId).orElseThrow();
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
    live.forget(buildId);
    events.publishEvent(BuildEvent.Changed.of(build));
    return Optional.of(
        new Assignment(
            attempt.key(),
            build.activityName(),
            build.model(),
            build.language(),
            build.files(),
            build.recordedCases(),
            settings.maxRecordings().toBytes()));
  }

  /**
   * Renews the leases of what an agent says it works on; answers with what it should not work on
   * any more.
   */
  public Set<AttemptKey> renew(String agent, Collection<AttemptKey> running) {
    if (running.isEmpty()) {
      return Set.of();
    }
    Set<Long> live =
        Set.copyOf(attempts.findLive(agent, running.stream().map(AttemptKey::token).toList()));
    if (!live.isEmpty()) {
      attempts.renew(live, now().plus(settings.lease()));
    }
    return running.stream()
        .filter(key -> !live.contains(key.token()))
        .collect(Collectors.toUnmodifiableSet());
  }

  /** Grants everybody a whole lease: while the server was away nobody could renew one. */
  public int renewAll() {
    return attempts.renewAll(now().plus(settings.lease()));
  }

  /** Attempts of agents that were not heard of for a lease. */
  @Transactional(readOnly = true)
  public List<AttemptKey> overdue() {
    return attempts.findOverdue(now());
  }

  /** When the next lease ends, if nobody renews it. */
  @Transactional(readOnly = true)
  public Optional<Instant> nextDeadline() {
    return attempts.findNextDeadline();
  }

  /** Gives up an attempt whose lease has ended, unless it was renewed meanwhile. */
  public void expire(AttemptKey key) {
    Optional<Build> build = builds.findForChange(key.buildId());
    Optional<Attempt> attempt = attempts.findById(key.token());
    if (build.isPresent() && attempt.isPresent() && attempt.get().isOverdue(now())) {
      giveUp(
          build.get(),
          attempt.get(),
          "nothing was heard of agent "
              + attempt.get().agent()
              + " for "
              + settings.lease().toSeconds()
              + " s");
    }
  }

  /**
   * Gives up what an agent had and does not have any more, because it was started anew.
   *
   * @param running what it says it works on
   */
  public void giveUpAllBut(String agent, Collection<AttemptKey> running) {
    Set<Long> kept = running.stream().map(AttemptKey::token).collect(Collectors.toSet());
    for (AttemptKey key : attempts.findLiveOf(agent)) {
      if (!kept.contains(key.token())) {
        giveUp(key, "agent " + agent + " was started anew and knows nothing of it");
      }
    }
  }

  /** Takes an agent's attempts away from it. */
  public void giveUpAll(String agent, String why) {
    attempts.findLiveOf(agent).forEach(key -> giveUp(key, why));
  }

  /** Which of these attempts are over. */
  @Transactional(readOnly = true)
  public Set<Long> over(Collection<Long> tokens) {
    return tokens.isEmpty() ? Set.of() : Set.copyOf(attempts.findOver(tokens));
  }

  /** Gives up an attempt that its agent did not even get to know of. */
  public void giveUp(AttemptKey key, String why) {
    Optional<Build> build = builds.findForChange(key.buildId());
    Optional<Attempt> attempt = attempts.findById(key.token());
    if (build.isPresent() && attempt.isPresent() && !attempt.get().isOver()) {
      giveUp(build.get(), attempt.get(), why);
    }
  }

  private void giveUp(Build build, Attempt attempt, String why) {
    attempt.end(BuildState.FAILED, now());
    events.publishEvent(new BuildEvent.Stopped(attempt.key(), attempt.agent(), why, true));
    retries.afterLoss(build, why);
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }
}
