package org.sitaf.server.build;

import jakarta.persistence.criteria.CriteriaBuilder;
import jakarta.persistence.criteria.Path;
import jakarta.persistence.criteria.Predicate;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.server.activity.ActivityDeletion;
import org.sitaf.server.build.BuildFailure.SourceProblem;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.BuildSource;
import org.sitaf.server.build.request.RealDevices;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.build.request.Reservation;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.quota.Quotas;
import org.sitaf.server.result.Results;
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

/** Requests, lists and cancels builds. */
@Service
public class Builds {
  private final BuildRepository builds;
  private final AttemptRepository attempts;
  private final Suites suites;
  private final StoredFiles contents;
  private final Results results;
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
      Results results,
      Quotas quotas,
      TransactionTemplate transaction,
      ApplicationEventPublisher events,
      SitafSettings settings,
      Clock clock) {
    this.builds = builds;
    this.attempts = attempts;
    this.suites = suites;
    this.contents = contents;
    this.results = results;
    this.quotas = quotas;
    this.transaction = transaction;
    this.events = events;
    this.settings = settings;
    this.clock = clock;
  }

  /**
   * Requests a build.
   *
   * @return its id
   * @throws InvalidInputException if the test application cannot be generated
   */
  public String request(String suiteId, BuildOptions options) {
    return request(suiteId, options, BuildSource.UNKNOWN);
  }

  /**
   * Requests a build of a known state of the sources.
   *
   * @return its id
   * @throws InvalidInputException if the test application cannot be generated
   */
  public String request(String suiteId, BuildOptions options, BuildSource source) {
    TestApplication application =
        selected(suites.application(suiteId, options.ros()), options.cases());
    quotas.requireBuild(application.files());
    return queue(suites.origin(suiteId), application, options, source, null);
  }

  /**
   * Requests a build of a test application that was made of other files than the activity's current
   * ones.
   *
   * @param stored called with the build's id in the transaction that stores the build
   * @return its id
   */
  public String request(
      SuiteOrigin origin,
      TestApplication application,
      BuildOptions options,
      BuildSource source,
      Consumer<String> stored) {
    return queue(origin, application, options, source, null, stored);
  }

  /**
   * Requests a build of the cases that did not pass in an earlier build of the same suite.
   *
   * @return its id
   * @throws InvalidInputException if the test application cannot be generated
   */
  public String requestFailed(
      String suiteId, String earlierId, BuildOptions options, BuildSource source) {
    if (!inspect(earlierId, Build::suiteId).equals(suiteId)) {
      throw RequestException.malformed(
          "failedOf: build " + earlierId + " is not a build of suite " + suiteId + ".");
    }
    Set<Integer> failed =
        results.load(earlierId).cases().stream()
            .filter(c -> c.verdict() != Verdict.PASS)
            .map(CaseResult::no)
            .collect(Collectors.toSet());
    if (failed.isEmpty()) {
      throw RequestException.conflict("All cases of build " + earlierId + " passed.");
    }
    return request(suiteId, options.withCases(CaseNumbers.of(failed)), source);
  }

  /**
   * Requests a build of a case that the suite of an earlier build does not contain.
   *
   * @param application with this case alone
   * @return its id
   */
  String requestFurther(String earlierId, TestApplication application) {
    quotas.requireBuild(application.files());
    return queue(
        suites.origin(inspect(earlierId, Build::suiteId)),
        application,
        BuildOptions.DEFAULT.withCases(
            CaseNumbers.of(
                application.suite().cases().stream()
                    .map(TestCase::no)
                    .collect(Collectors.toSet()))),
        inspect(earlierId, Build::source),
        null);
  }

  private static TestApplication selected(
      TestApplication application, @Nullable CaseNumbers numbers) {
    if (numbers == null) {
      return application;
    }
    TestSuite suite = application.suite();
    List<CaseNumbers.Range> missing = numbers.missing(suite);
    if (!missing.isEmpty()) {
      throw RequestException.malformed(
          "cases: "
              + missing.get(0)
              + " does not exist; the suite has "
              + suite.cases().size()
              + " cases, numbered "
              + suite.cases().stream().mapToInt(TestCase::no).min().orElse(0)
              + " to "
              + suite.cases().stream().mapToInt(TestCase::no).max().orElse(0)
              + ".");
    }
    return Shards.withCases(application, numbers.select(suite).cases());
  }

  /**
   * Requests the build of a fire time, unless it was requested before. If the test application
   * cannot be generated, a failed build is created, which shows the reason.
   *
   * @return the id of the build of this fire time
   */
  public String requestReserved(String suiteId, BuildOptions options, Reservation reservation) {
    Optional<String> existing = find(reservation);
    if (existing.isPresent()) {
      return existing.get();
    }
    SuiteOrigin origin = suites.origin(suiteId);
    try {
      return queue(
          origin,
          suites.application(suiteId, options.ros()),
          options,
          BuildSource.UNKNOWN,
          reservation);
    } catch (InvalidInputException e) {
      return insertFailed(
          origin,
          options,
          reservation,
          "The test application cannot be generated.",
          e.diagnostics());
    } catch (RequestException e) {
      return insertFailed(origin, options, reservation, String.valueOf(e.getMessage()), List.of());
    } catch (DataIntegrityViolationException e) {
      // Another server was faster; a unique constraint allows one build per fire time.
      return find(reservation).orElseThrow(() -> e);
    }
  }

  /**
   * Criteria for builds; null means any.
   *
   * @param parentId the build whose shards are listed; null for whole builds only
   * @param search a part of the activity's or the model's name, in upper or lower case
   */
  public record Filter(
      @Nullable String activityId,
      @Nullable BuildState state,
      @Nullable String scheduleId,
      @Nullable String parentId,
      @Nullable String commit,
      @Nullable String search) {}

  /** Applies a function to a build within a transaction. */
  public <T> T inspect(String id, Function<Build, T> view) {
    return required(
        transaction.execute(
            status ->
                view.apply(
                    builds
                        .findById(id)
                        .orElseThrow(() -> RequestException.notFound("build", id)))));
  }

  /** Returns a page of the builds that match the filter. */
  public <T> Page<T> list(Filter filter, Pageable page, Function<Build, T> view) {
    Specification<Build> specification =
        (build, query, is) ->
            is.and(
                is.equal(build.get("kind"), BuildKind.TEST),
                filter.activityId() == null
                    ? is.conjunction()
                    : is.equal(build.get("activityId"), filter.activityId()),
                filter.state() == null
                    ? is.conjunction()
                    : is.equal(build.get("state"), filter.state()),
                filter.scheduleId() == null
                    ? is.conjunction()
                    : is.equal(build.get("scheduleId"), filter.scheduleId()),
                filter.commit() == null
                    ? is.conjunction()
                    : is.equal(build.get("commitId"), filter.commit()),
                filter.search() == null
                    ? is.conjunction()
                    : is.or(
                        contains(is, build.get("activityName"), filter.search()),
                        contains(is, build.get("model"), filter.search())),
                filter.parentId() == null
                    ? is.isNull(build.get("parentId"))
                    : is.equal(build.get("parentId"), filter.parentId()));
    return required(transaction.execute(status -> builds.findAll(specification, page).map(view)));
  }

  /** With locate, no character of the searched text is a wildcard. */
  private static Predicate contains(CriteriaBuilder is, Path<String> text, String searched) {
    return is.greaterThan(is.locate(is.lower(text), searched.toLowerCase(Locale.ROOT)), 0);
  }

  /** Cancels a build that has not ended. */
  public void cancel(String id, String cause) {
    transaction.executeWithoutResult(
        status -> {
          Build build =
              builds.findForUpdate(id).orElseThrow(() -> RequestException.notFound("build", id));
          boolean active = build.state().isActive() && build.shards() == 0;
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
    List<Build> all = builds.findByActivityId(deletion.activityId());
    all.stream()
        .filter(b -> !b.state().isOver())
        .findFirst()
        .ifPresent(
            b -> {
              throw RequestException.conflict(
                  "Build "
                      + b.id()
                      + " of the activity is "
                      + b.state()
                      + "; cancel it first, or wait until it ends.");
            });
    events.publishEvent(new BuildEvent.Deleted(all.stream().map(Build::id).toList()));
  }

  private String queue(
      SuiteOrigin origin,
      TestApplication application,
      BuildOptions options,
      BuildSource source,
      @Nullable Reservation reservation) {
    return queue(origin, application, options, source, reservation, id -> {});
  }

  private String queue(
      SuiteOrigin origin,
      TestApplication application,
      BuildOptions options,
      BuildSource source,
      @Nullable Reservation reservation,
      Consumer<String> stored) {
    Requirements requirements = Requirements.of(application, options.agent());
    RealDevices.requireAllowed(requirements, options);
    List<StoredFile> files = contents.store(application.files());
    Build build =
        create(
            origin, FrozenApplication.of(application, requirements, files), options, reservation);
    build.describe(source);
    List<Build> all = new ArrayList<>(List.of(build));
    List<TestApplication> shards = Shards.split(application, options.shards());
    for (int no = 1; no <= shards.size(); no++) {
      TestApplication shard = shards.get(no - 1);
      List<StoredFile> shardFiles = contents.store(shard.files());
      FrozenApplication frozen = FrozenApplication.of(shard, requirements, shardFiles);
      all.add(build.addShard(UUID.randomUUID().toString(), no, frozen, now()));
    }
    return insert(all, stored);
  }

  private Build create(
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

  private String insertFailed(
      SuiteOrigin origin,
      BuildOptions options,
      Reservation reservation,
      String message,
      List<Diagnostic> diagnostics) {
    Build build = create(origin, FrozenApplication.NONE, options, reservation);
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
    return insert(List.of(build), id -> {});
  }

  /** Inserts a build together with its shards. */
  private String insert(List<Build> all, Consumer<String> stored) {
    String id = all.get(0).id();
    transaction.executeWithoutResult(
        status -> {
          all.forEach(
              build -> {
                builds.saveAndFlush(build);
                quotas.ownBuild(build.id());
                changed(build);
              });
          stored.accept(id);
        });
    return id;
  }

  private Optional<String> find(Reservation reservation) {
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
