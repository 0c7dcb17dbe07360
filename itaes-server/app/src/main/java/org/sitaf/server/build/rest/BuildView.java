package org.sitaf.server.build.rest;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.server.build.AttemptSummary;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.BuildFailure;
import org.sitaf.server.build.BuildKind;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.build.CaseCounts;
import org.sitaf.server.build.Transition;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.build.request.Requirement;
import org.sitaf.server.build.request.Reservation;

/** A build in the REST interface. */
@Schema(name = "Build")
record BuildView(
    String id,
    String activityId,
    String activityName,
    String suiteId,
    String model,
    State state,
    @Schema(description = "number of the latest attempt, from 1; 0 if there is none") int attempt,
    @Schema(description = "agent of the latest attempt") @Nullable String agent,
    Instant created,
    @Schema(description = "when it was first assigned to an agent") @Nullable Instant started,
    @Nullable Instant finished,
    @Schema(description = "increases with each change") long version,
    int casesTotal,
    int casesDone,
    @Schema(description = "why it is queued; only while QUEUED") @Nullable String waitingFor,
    @Schema(description = "only when FAILED") @Nullable FailureView failure,
    @Schema(description = "only when DONE") @Nullable CountsView summary,
    @Schema(
            description =
                "why the verdicts cannot be trusted; a build with suspicions has not passed")
        List<String> suspicions,
    @Schema(description = "schedule that requested it") @Nullable String scheduleId,
    @Schema(description = "-100 to 100; builds with higher priority run first") int priority,
    @Schema(description = "requirements for the agent, in words") List<String> requirements,
    @Schema(description = "time of the next attempt after an infrastructure failure")
        @Nullable Instant notBefore,
    @Schema(description = "number of shards; absent if it has none") @Nullable Integer shards,
    @Schema(description = "number of this shard, from 1; absent for a whole build")
        @Nullable Integer shard,
    @Schema(description = "build that the shard belongs to; absent for a whole build")
        @Nullable String parentId,
    @Schema(description = "which cases are recorded in the simulation") RecordedCases recordedCases,
    @Schema(description = "requested labels of the agent") List<String> labels,
    @Schema(description = "requested version of the toolchain; absent for any")
        @Nullable String toolchain,
    @Schema(description = "maximum number of retries after infrastructure failures") int retries,
    @Schema(
            description =
                "id of the tested commit, with the suffix -dirty if the files differ from it;"
                    + " absent if it is not known")
        @Nullable String commit,
    @Schema(description = "what the requester says about the build, by key")
        Map<String, String> buildLabels,
    @Schema(description = "the cases that were requested, such as 9,12-20; absent for all")
        @Nullable String cases,
    @Schema(description = "TEST: executes cases; otherwise an analysis of another build")
        BuildKind kind,
    @Schema(description = "build that is analysed; absent for kind TEST")
        @Nullable String analysedId,
    @Schema(description = "whether the failures are explained when the build ends") boolean explain,
    @Schema(description = "what a ROS 2 node runs with, as in a build request")
        RosImplementation ros) {

  /** The states of {@link BuildState}, except those of attempts only. */
  enum State {
    QUEUED,
    LEASED,
    PREPARING,
    COMPILING,
    RUNNING,
    UPLOADING,
    DONE,
    FAILED,
    CANCELLED
  }

  @Schema(name = "BuildFailure")
  record FailureView(
      BuildFailure.Category category, String message, List<ProblemView> diagnostics) {
    static FailureView of(BuildFailure failure) {
      return new FailureView(
          failure.category(),
          failure.message(),
          failure.problems().stream()
              .map(
                  p ->
                      new ProblemView(
                          p.file(), p.line(), p.columnNo(), p.message(), p.isGenerated()))
              .toList());
    }
  }

  @Schema(name = "SourceProblem")
  record ProblemView(
      String file,
      @Schema(description = "from 1; 0 if unknown") int line,
      @Schema(description = "from 1; 0 if unknown") int column,
      String message,
      @Schema(description = "whether the file was generated") boolean generated) {}

  @Schema(name = "Verdicts", description = "total = pass + fail + error + dont")
  record CountsView(
      int total,
      int pass,
      int fail,
      int error,
      @Schema(description = "not executed") int dont,
      @Schema(description = "passed without an expected value or post-condition") int unjudged,
      @Schema(description = "passed by an exception, which says nothing about values")
          int byError) {
    static CountsView of(CaseCounts counts) {
      return new CountsView(
          counts.total(),
          counts.pass(),
          counts.fail(),
          counts.error(),
          counts.dont(),
          counts.unjudged(),
          counts.byError() == null ? 0 : counts.byError());
    }
  }

  @Schema(name = "BuildTransition")
  record TransitionView(
      @Schema(description = "from 1; 0 before the first") int attempt,
      State state,
      Instant time,
      String cause) {
    static TransitionView of(Transition transition) {
      return new TransitionView(
          transition.attempt(),
          State.valueOf(transition.state().name()),
          transition.atTime(),
          transition.cause());
    }
  }

  @Schema(name = "BuildAttempt")
  record AttemptView(
      @Schema(description = "from 1") int no,
      String agent,
      BuildState state,
      Instant leased,
      @Nullable Instant finished) {
    static AttemptView of(AttemptSummary attempt) {
      return new AttemptView(
          attempt.no(), attempt.agent(), attempt.state(), attempt.leased(), attempt.finished());
    }
  }

  /**
   * Creates the view of a build.
   *
   * @param waitingFor why the build is queued; null if it is not
   */
  static BuildView of(Build build, @Nullable String waitingFor) {
    return new BuildView(
        build.id(),
        build.activityId(),
        build.activityName(),
        build.suiteId(),
        build.model(),
        State.valueOf(build.state().name()),
        build.attempt(),
        build.agent().orElse(null),
        build.created(),
        build.started().orElse(null),
        build.finished().orElse(null),
        build.version(),
        build.casesTotal(),
        build.casesDone(),
        waitingFor,
        build.failure().map(FailureView::of).orElse(null),
        build.counts().map(CountsView::of).orElse(null),
        build.suspicions(),
        build.reservation().map(Reservation::scheduleId).orElse(null),
        build.priority(),
        build.requirements().all().stream().map(Requirement::words).toList(),
        build.notBefore().filter(t -> build.state() == BuildState.QUEUED).orElse(null),
        build.shards() == 0 ? null : build.shards(),
        build.shard() == 0 ? null : build.shard(),
        build.parentId().orElse(null),
        build.recordedCases(),
        requirements(build, Requirement.Label.class).map(Requirement.Label::name).toList(),
        requirements(build, Requirement.Version.class)
            .map(Requirement.Version::version)
            .findFirst()
            .orElse(null),
        build.maxAttempts() - 1,
        build.source().commit(),
        new TreeMap<>(build.source().labels()),
        build.caseNumbers().orElse(null),
        build.kind(),
        build.analysedId().orElse(null),
        build.explainsFailures(),
        build.requirements().rosImplementation());
  }

  private static <R extends Requirement> Stream<R> requirements(Build build, Class<R> kind) {
    return build.requirements().all().stream().filter(kind::isInstance).map(kind::cast);
  }
}
