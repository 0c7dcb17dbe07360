package org.sitaf.server.history;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.compare.result.CaseChanges;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.comparison.BuiltVersions;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.result.Results;
import org.springframework.stereotype.Service;

/**
 * Follows a case through the commits of a branch or the builds of its model. Cases with the same
 * inputs are the same case, as in a comparison of results.
 */
@Service
class CaseHistories {
  private final CaseHistoryRows rows;
  private final StoredActivities activities;
  private final GitSources sources;
  private final Results results;
  private final BuiltVersions versions;
  private final ValidCases validCases;

  CaseHistories(
      CaseHistoryRows rows,
      StoredActivities activities,
      GitSources sources,
      Results results,
      BuiltVersions versions,
      ValidCases validCases) {
    this.rows = rows;
    this.activities = activities;
    this.sources = sources;
    this.results = results;
    this.versions = versions;
    this.validCases = validCases;
  }

  /** What the points of a line are. */
  enum Points {
    COMMITS,
    BUILDS
  }

  /**
   * Which case, in which builds.
   *
   * @param buildId a build with the case; null for the one with the newest result of the model
   * @param no number of the case in that build
   * @param points null for commits if the activity comes from Git, else builds
   */
  record Request(
      String activityId, String model, @Nullable String buildId, int no, @Nullable Points points) {}

  /**
   * A page of the line of a case, the newest point first.
   *
   * @param total number of points on all pages
   */
  record History(
      String buildId,
      CaseResult testCase,
      List<CaseParameter> parameters,
      Points by,
      List<Judged> points,
      long total) {}

  /**
   * A point of a line.
   *
   * @param valid whether all inputs of the case are valid; null if that is not known
   * @param verdictChanged since the nearest earlier point with a result; null if there is none
   * @param valueChanged like {@code verdictChanged}
   */
  record Judged(
      CasePoint point,
      @Nullable Boolean valid,
      @Nullable Boolean verdictChanged,
      @Nullable Boolean valueChanged) {}

  /**
   * Returns a page of the line of a case.
   *
   * @throws RequestException if the activity, the build or the case does not exist
   */
  History of(Request request, int size, long offset) {
    String activity = request.activityId();
    String unused = activities.name(activity);
    Optional<GitSource> source = source(request);
    String buildId = build(request, source);
    CaseHistoryRows.Identified identified =
        rows.find(buildId, request.no())
            .orElseThrow(
                () ->
                    RequestException.notFound(
                        "The result of build %s has no case %d; use a number from its list of cases."
                            .formatted(buildId, request.no())));
    if (identified.fingerprint() == null) {
      throw RequestException.conflict(
          "The result of build " + buildId + " cannot be read; use the case of another build.");
    }
    CaseHistoryRows.Line line =
        new CaseHistoryRows.Line(
            activity,
            source.map(GitSource::id).orElse(null),
            request.model(),
            identified.fingerprint());
    List<CaseParameter> parameters = results.parameters(buildId);
    List<CasePoint> points = rows.points(line, size, offset);
    return new History(
        buildId,
        identified.result(),
        parameters,
        source.isPresent() ? Points.COMMITS : Points.BUILDS,
        judged(line, points, changes(buildId, request.model(), parameters)),
        rows.count(line));
  }

  private Optional<GitSource> source(Request request) {
    if (request.points() == Points.BUILDS) {
      return Optional.empty();
    }
    return request.points() == Points.COMMITS
        ? Optional.of(sources.require(request.activityId()))
        : sources.find(request.activityId());
  }

  private String build(Request request, Optional<GitSource> source) {
    String given = request.buildId();
    if (given == null) {
      return source
          .flatMap(of -> rows.newestOfBranch(of.id(), request.model()))
          .or(() -> rows.newest(request.activityId(), request.model()))
          .orElseThrow(
              () ->
                  RequestException.notFound(
                      "The activity has no result of a test model '%s'; build it first."
                          .formatted(request.model())));
    }
    if (!rows.isOf(request.activityId(), request.model(), given)) {
      throw RequestException.notFound(
          "The activity has no build '%s' of the test model '%s'."
              .formatted(given, request.model()));
    }
    return given;
  }

  /** The types of outputs decide which numbers differ in the last bits only. */
  private CaseChanges changes(String buildId, String model, List<CaseParameter> parameters) {
    Activity activity = versions.activity(buildId);
    return new CaseChanges(activity, StoredActivities.model(activity, model), parameters);
  }

  private List<Judged> judged(
      CaseHistoryRows.Line line, List<CasePoint> newestFirst, CaseChanges changes) {
    Map<String, Set<Integer>> invalid =
        validCases.invalid(
            newestFirst.stream()
                .filter(point -> point.result() != null)
                .map(point -> Objects.requireNonNull(point.buildId()))
                .distinct()
                .toList());
    List<Judged> judged = new ArrayList<>();
    CasePoint before =
        newestFirst.isEmpty()
            ? null
            : rows.judgedBefore(line, newestFirst.get(newestFirst.size() - 1)).orElse(null);
    for (int i = newestFirst.size() - 1; i >= 0; i--) {
      CasePoint point = newestFirst.get(i);
      judged.add(judged(point, before, invalid, changes));
      if (point.result() != null && !point.replaced()) {
        before = point;
      }
    }
    Collections.reverse(judged);
    return judged;
  }

  private static Judged judged(
      CasePoint point,
      @Nullable CasePoint before,
      Map<String, Set<Integer>> invalid,
      CaseChanges changes) {
    CaseResult now = point.result();
    if (now == null) {
      return new Judged(point, null, null, null);
    }
    Set<Integer> numbers = invalid.get(point.buildId());
    Boolean valid = numbers == null ? null : !numbers.contains(now.no());
    CaseResult earlier = before == null ? null : before.result();
    // What a force-push has removed follows other commits than those of the branch.
    if (earlier == null || point.replaced()) {
      return new Judged(point, valid, null, null);
    }
    boolean sameBuild = Objects.equals(point.buildId(), Objects.requireNonNull(before).buildId());
    return new Judged(
        point,
        valid,
        now.verdict() != earlier.verdict(),
        !sameBuild && changes.differ(earlier, now));
  }
}
