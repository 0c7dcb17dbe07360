package org.sitaf.server.build.rest;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.BuildFailure;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.build.CaseCounts;
import org.sitaf.server.build.PastAttempt;
import org.sitaf.server.build.Transition;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.build.request.Requirement;
import org.sitaf.server.build.request.Reservation;

/** A build as people and programs see it. */
@Schema(name = "Build")
record BuildView(
    String id,
    String activityId,
    String activityName,
    String suiteId,
    String model,
    State state,
    @Schema(description = "from 1; 0 before the first") int attempt,
    @Schema(description = "that has the latest attempt") @Nullable String agent,
    Instant created,
    @Schema(description = "when it was first given to an agent") @Nullable Instant started,
    @Nullable Instant finished,
    @Schema(description = "grows with each change") long version,
    int casesTotal,
    int casesDone,
    @Schema(description = "why it waits; only while QUEUED") @Nullable String waitingFor,
    @Schema(description = "only when FAILED") @Nullable FailureView failure,
    @Schema(description = "only when DONE") @Nullable CountsView summary,
    @Schema(
            description =
                "why the verdicts are not to be trusted; a build that has any has not passed")
        List<String> suspicions,
    @Schema(description = "that reserved it") @Nullable String scheduleId,
    @Schema(description = "-100 to 100; higher ones are given to agents first") int priority,
    @Schema(description = "what an agent must have for it, in words") List<String> requirements,
    @Schema(description = "when it may be given to an agent again after a failure of one")
        @Nullable Instant notBefore,
    @Schema(description = "over how many builds its cases are spread; absent for one")
        @Nullable Integer shards,
    @Schema(description = "which of the shards of its parent it is, from 1")
        @Nullable Integer shard,
    @Schema(description = "build whose cases are spread over it and others")
        @Nullable String parentId,
    @Schema(description = "of which cases it is recorded what moves in the simulation")
        RecordedCases recordedCases,
    @Schema(description = "that the agent must have, as requested") List<String> labels,
    @Schema(description = "release of the component's tools, as requested; absent for any")
        @Nullable String toolchain,
    @Schema(description = "allowed after failures of the infrastructure") int retries) {

  /** As {@link BuildState}, without what only attempts can be. */
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
      @Schema(description = "from 1; 0 where unknown") int line,
      @Schema(description = "from 1; 0 where unknown") int column,
      String message,
      @Schema(description = "whether the file was generated") boolean generated) {}

  @Schema(name = "Verdicts", description = "total = pass + fail + error + dont")
  record CountsView(
      int total,
      int pass,
      int fail,
      int error,
      @Schema(description = "not executed") int dont,
      @Schema(description = "passed without an expected value or post-condition") int unjudged) {
    static CountsView of(CaseCounts counts) {
      return new CountsView(
          counts.total(),
          counts.pass(),
          counts.fail(),
          counts.error(),
          counts.dont(),
          counts.unjudged());
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
    static AttemptView of(PastAttempt attempt) {
      return new AttemptView(
          attempt.no(), attempt.agent(), attempt.state(), attempt.leased(), attempt.finished());
    }
  }

  /**
   * A view.
   *
   * @param waitingFor why the build waits; null where it does not
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
        build.parts() == 0 ? null : build.parts(),
        build.part() == 0 ? null : build.part(),
        build.parentId().orElse(null),
        build.recordedCases(),
        requirements(build, Requirement.Label.class).map(Requirement.Label::name).toList(),
        requirements(build, Requirement.Version.class)
            .map(Requirement.Version::version)
            .findFirst()
            .orElse(null),
        build.maxAttempts() - 1);
  }

  private static <R extends Requirement> Stream<R> requirements(Build build, Class<R> kind) {
    return build.requirements().all().stream().filter(kind::isInstance).map(kind::cast);
  }
}
