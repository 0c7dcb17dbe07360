package org.sitaf.server.git.commit.rest;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.git.commit.GitCell;
import org.sitaf.server.git.commit.GitCommit;

/** A commit of a Git source in the REST interface. */
@Schema(name = "GitCommit")
public record CommitView(
    String sha,
    @Schema(description = "number of the pull or merge request; 0 for the branch") int request,
    @Schema(
            description =
                "whether it is built only to compare the heads of the request with it; such a"
                    + " commit gets no status at the forge")
        boolean mergeBase,
    String subject,
    String author,
    Instant authored,
    @Schema(description = "when the server fetched it") Instant received,
    @Schema(description = "when all its builds had ended") @Nullable Instant ended,
    GitCommit.State state,
    @Schema(description = "why it cannot be built, and what to do") @Nullable String problem,
    @Schema(description = "the commit that it is compared with; absent for the first one")
        @Nullable String base,
    @Schema(
            description =
                "number of commits of the branch between the base and this one that were not built")
        int notBuilt,
    @Schema(description = "whether a force-push has removed it from the branch") boolean replaced,
    @Schema(description = "one for each model") List<CellView> cells) {

  @Schema(name = "GitCell")
  public record CellView(
      String model,
      String buildId,
      @Schema(description = "build of the base; absent if the base does not have the model")
          @Nullable String baseBuildId,
      @Schema(
              description =
                  "the commit whose result was taken over, since the build would read the same"
                      + " bytes; absent if this commit was built")
          @Nullable String takenFrom,
      BuildState state,
      @Schema(description = "whether the verdicts cannot be trusted") boolean suspect,
      @Schema(description = "number of cases; absent before there is a result")
          @Nullable Integer total,
      @Nullable Integer pass,
      @Nullable Integer fail,
      @Nullable Integer error,
      @Schema(description = "why the build has no result") @Nullable String failure,
      @Schema(description = "cases compared with the base; absent if they were not")
          @Nullable Integer compared,
      @Nullable Integer differing) {
    static CellView of(GitCell cell, @Nullable String baseBuildId) {
      return new CellView(
          cell.model(),
          cell.buildId(),
          baseBuildId,
          cell.takenFrom(),
          cell.state(),
          cell.suspect(),
          cell.total(),
          cell.pass(),
          cell.fail(),
          cell.error(),
          cell.failure(),
          cell.compared(),
          cell.differing());
    }
  }
}
