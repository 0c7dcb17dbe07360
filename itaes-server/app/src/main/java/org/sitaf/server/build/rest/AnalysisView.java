package org.sitaf.server.build.rest;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.Build;
import org.sitaf.server.build.BuildFailure;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.build.analysis.ExplanationView;
import org.sitaf.server.build.analysis.RepetitionView;
import org.sitaf.server.build.analysis.ScoreView;

/** An analysis of a build: an explanation, a score or a repetition. */
@Schema(name = "BuildAnalysis")
record AnalysisView(
    @Schema(description = "id of the analysis, which is a build: it can be cancelled and has a log")
        String id,
    @Schema(description = "as of a build") BuildState state,
    Instant created,
    @Nullable Instant started,
    @Nullable Instant finished,
    @Nullable String agent,
    @Schema(description = "number of executed cases so far") int executed,
    @Schema(description = "maximum number of further cases") int maxCases,
    @Schema(description = "why it is queued; only while QUEUED") @Nullable String waitingFor,
    @Schema(description = "why it failed; only when FAILED") @Nullable String failure,
    @Schema(description = "only of a finished explanation") @Nullable ExplanationView explanation,
    @Schema(description = "only of a finished score") @Nullable ScoreView score,
    @Schema(description = "only of a finished repetition") @Nullable RepetitionView repetition) {
  /**
   * An analysis as it is now.
   *
   * @param report of its kind; null if it has none
   */
  static AnalysisView of(Build analysis, @Nullable String waitingFor, @Nullable Object report) {
    return new AnalysisView(
        analysis.id(),
        analysis.state(),
        analysis.created(),
        analysis.started().orElse(null),
        analysis.finished().orElse(null),
        analysis.agent().orElse(null),
        analysis.casesDone(),
        analysis.casesTotal(),
        waitingFor,
        analysis.failure().map(AnalysisView::text).orElse(null),
        report instanceof ExplanationView explanation ? explanation : null,
        report instanceof ScoreView score ? score : null,
        report instanceof RepetitionView repetition ? repetition : null);
  }

  private static String text(BuildFailure failure) {
    return failure.problems().isEmpty()
        ? failure.message()
        : failure.message() + ": " + failure.problems().get(0).message();
  }
}
