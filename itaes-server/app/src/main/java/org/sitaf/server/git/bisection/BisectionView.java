package org.sitaf.server.git.bisection;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.server.build.BuildState;

/** A search for the first bad commit in the REST interface. */
@Schema(name = "GitBisection")
record BisectionView(
    @Schema(description = "from 1") int number,
    GitBisection.State state,
    @Schema(description = "the commit that somebody asked about") String bad,
    @Schema(description = "the last commit before that has results") String good,
    @Schema(
            description =
                "FAILURES: a case fails that passes at the good commit; VALUES: a case"
                    + " has other values than at the good commit")
        GitBisection.Kind kind,
    @Schema(description = "what a bad commit does, with the numbers of the first cases")
        String criterion,
    @Schema(description = "number of commits after the good one up to the bad one") int commits,
    @Schema(description = "number of commits of which one is the first bad one") int left,
    @Schema(description = "number of commits that were built for this search") int builds,
    @Schema(description = "the commit whose builds the search waits for; absent if it has ended")
        @Nullable String testing,
    @Schema(description = "commits that were tested, in the order of the tests")
        List<TestedCommitView> tested,
    @Schema(
            description =
                "the first bad commit; several if the others cannot be tested; empty before the"
                    + " search has ended")
        List<TestedCommitView> firstBad,
    @Schema(description = "why the search ended without a single commit, and what to do")
        @Nullable String problem,
    String askedBy,
    Instant created,
    @Nullable Instant ended) {

  @Schema(name = "GitBisectionCommit")
  record TestedCommitView(
      String sha,
      String subject,
      String author,
      Instant authored,
      @Schema(description = "absent if it was not tested") @Nullable Outcome outcome,
      @Schema(description = "why it is bad or cannot be tested") @Nullable String reason,
      @Schema(description = "one for each model that decides; empty if it was not built")
          List<BuildOfCommitView> results) {}

  @Schema(name = "GitBisectionResult")
  record BuildOfCommitView(
      String model,
      String buildId,
      BuildState state,
      @Schema(
              description =
                  "build to compare with: of the commit before if that is good, otherwise of the"
                      + " good commit")
          String baseBuildId) {}
}
