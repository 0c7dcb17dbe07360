package org.sitaf.server.build;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.server.activity.ActivityDeletion;
import org.sitaf.server.build.BuildFailure.SourceProblem;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.build.request.Reservation;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.quota.Quotas;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.suite.SuiteOrigin;
import org.sitaf.server.suite.Suites;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.context.event.EventListener;
import org.springframework.dao.DataIntegrityViolationException;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.data.jpa.domain.Specification;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** Build requests: made, looked at, cancelled. */
@Service
public class Builds {
  private final BuildRepository builds;
  private final AttemptRepository attempts;
  private final Suites suites;
  private final StoredFiles contents;
  private final Quotas quotas;
  private final TransactionTemplate transaction;
  private final ApplicationEventPublisher events;
  private final SitafSettings settings;
  private final Clock clock;

  Builds(
      BuildRepository builds,
      AttemptRepository attempts,
      Suites suites,
      StoredFiles contents,
      Quotas quotas,
      TransactionTemplate transaction,
      ApplicationEventPublisher events,
      SitafSettings settings,
      Clock clock) {
    this.builds = builds;
    this.attempts = attempts;
    this.suites = suites;
    this.contents = contents;
    this.quotas = quotas;
    this.transaction = transaction;
    this.events = events;
    this.settings = settings;
    this.clock = clock;
  }

  /**
   * Requests a build at once.
   *
   * @return its id
   * @throws InvalidInputException when no test application can be made of the suite
   */
  public String request(String suiteId, BuildOptions options) {
    TestApplication application = suites.application(suiteId);
    quotas.requireBuild(application.files());
    return queue(suites.origin(suiteId), application, options, null);
  }

  /**
   * Requests the build of a reservation, unless that was done before. A suite that does not make a
   * test application any more gives a build that failed, so that people see why nothing ran.
   *
   * @return the id of the one build of this reservation
   */
  public String requestReserved(String suiteId, BuildOptions options, Reservation reservation) {
    Optional<String> made = made(reservation);
    if (made.isPresent()) {
      return made.get();
    }
    SuiteOrigin origin = suites.origin(suiteId);
    try {
      return queue(origin, suites.application(suiteId), options, reservation);
    } catch (InvalidInputException e) {
      return failed(
          origin, options, reservation, "The suite makes no test application.", e.diagnostics());
    } catch (Refusal e) {
      return failed(origin, options, reservation, String.valueOf(e.getMessage()), List.of());
    } catch (DataIntegrityViolationException e) {
      // Another server was faster; the database lets only one of them in.
      return made(reservation).orElseThrow(() -> e);
    }
  }

  /**
   * Which builds; null is any.
   *
   * @param parentId whose parts; null for whole builds only
   */
  public record Filter(
      @Nullable String activityId,
      @Nullable BuildState state,
      @Nullable String scheduleId,
      @Nullable String parentId) {}

  /** Views a build, within a transaction. */
  public <T> T inspect(String id, Function<Build, T> view) {
    return required(
        transaction.execute(
            status ->
                view.apply(builds.findById(id).orElseThrow(() -> Refusal.notFound("build", id)))));
  }

  /** A page of the builds that fit; each viewed within the transaction. */
  public <T> Page<T> list(Filter filter, Pageable page, Function<Build, T> view) {
    Specification<Build> wanted =
        (build, query, is) ->
            is.and(
                filter.activityId() == null
                    ? is.conjunction()
                    : is.equal(build.get("activityId"), filter.activityId()),
                filter.state() == null
                    ? is.conjunction()
                    : is.equal(build.get("state"), filter.state()),
                filter.scheduleId() == null
                    ? is.conjunction()
                    : is.equal(build.get("scheduleId"), filter.scheduleId()),
                filter.parentId() == null
                    ? is.isNull(build.get("parentId"))
                    : is.equal(build.get("parentId"), filter.parentId()));
    return required(transaction.execute(status -> builds.findAll(wanted, page).map(view)));
  }

  /** Cancels a build in whatever state it is, unless it is over. */
  public void cancel(String id, String cause) {
    transaction.executeWithoutResult(
        status -> {
          Build build = builds.findForChange(id).orElseThrow(() -> Refusal.notFound("build", id));
          boolean active = build.state().isActive() && build.parts() == 0;
          Instant now = now();
          build.cancel(cause, now);
          if (active) {
            Attempt attempt = attempts.findByBuildIdAndNo(id, build.attempt()).orElseThrow();
            attempt.end(BuildState.CANCELLED, now);
            events.publishEvent(
                new BuildEvent.Stopped(attempt.key(), attempt.agent(), cause, false));
          }
          changed(build);
        });
  }

  @EventListener
  void on(ActivityDeletion deletion) {
    List<Build> all = builds.findByActivityId(deletion.workspaceId());
    all.stream()
        .filter(b -> !b.state().isOver())
        .findFirst()
        .ifPresent(
            b -> {
              throw Refusal.conflict(
                  "Build "
                      + b.id()
                      + " of the activity is "
                      + b.state()
                      + "; cancel it first, or wait for its end.");
            });
    events.publishEvent(new BuildEvent.Deleted(all.stream().map(Build::id).toList()));
  }

  private String queue(
      SuiteOrigin origin,
      TestApplication application,
      BuildOptions options,
      @Nullable Reservation reservation) {
    Requirements requirements = Requirements.of(application, options.agent());
    List<StoredFile> files = contents.store(application.files());
    Build build =
        make(origin, FrozenApplication.of(application, requirements, files), options, reservation);
    List<Build> all = new ArrayList<>(List.of(build));
    List<TestApplication> parts = Parts.split(application, options.parts());
    for (int no = 1; no <= parts.size(); no++) {
      TestApplication part = parts.get(no - 1);
      List<StoredFile> partFiles = contents.store(part.files());
      FrozenApplication frozen = FrozenApplication.of(part, requirements, partFiles);
      all.add(build.part(UUID.randomUUID().toString(), no, frozen, now()));
    }
    return insert(all);
  }

  private Build make(
      SuiteOrigin origin,
      FrozenApplication application,
      BuildOptions options,
      @Nullable Reservation reservation) {
    Integer retries = options.retries();
    return new Build(
        UUID.randomUUID().toString(),
        origin,
        application,
        options,
        retries == null ? settings.maxAttempts() : retries + 1,
        reservation,
        now());
  }

  private String failed(
      SuiteOrigin origin,
      BuildOptions options,
      Reservation reservation,
      String message,
      List<Diagnostic> diagnostics) {
    Build build = make(origin, FrozenApplication.NONE, options, reservation);
    build.fail(
        new BuildFailure(
            BuildFailure.Category.INPUT,
            message,
            diagnostics.stream()
                .map(
                    d ->
                        new SourceProblem(
                            d.file(),
                            d.line(),
                            0,
                            d.element().isEmpty() ? d.message() : d.element() + ": " + d.message(),
                            false))
                .toList()),
        now());
    return insert(List.of(build));
  }

  /** All at once: nobody sees a build without its parts. */
  private String insert(List<Build> all) {
    transaction.executeWithoutResult(
        status ->
            all.forEach(
                build -> {
                  builds.saveAndFlush(build);
                  quotas.ownBuild(build.id());
                  changed(build);
                }));
    return all.get(0).id();
  }

  private Optional<String> made(Reservation reservation) {
    return builds.findIdByReservation(reservation.scheduleId(), reservation.fireTime());
  }

  private void changed(Build build) {
    events.publishEvent(BuildEvent.Changed.of(build));
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }

  private static <T> T required(@Nullable T result) {
    return Optional.ofNullable(result).orElseThrow();
  }
}
