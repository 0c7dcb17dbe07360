package org.sitaf.server.git.request;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.git.commit.rest.CommitView;

/** A pull or merge request in the REST interface. */
@Schema(name = "GitRequest")
record RequestView(
    int number,
    String title,
    String author,
    @Schema(description = "id of the newest commit that is known") String head,
    @Schema(description = "whether its commits come from another repository, or may come from one")
        boolean fork,
    GitRequest.State state,
    @Schema(description = "whether nothing is fetched or built before somebody asks for the head")
        boolean waitsForApproval,
    @Schema(description = "the last head that somebody asked to build") @Nullable String askedHead,
    @Schema(description = "who did") @Nullable String askedBy,
    @Nullable Instant asked,
    @Schema(description = "when the forge first reported it") Instant received,
    @Schema(description = "when the forge last reported it") Instant updated,
    @Schema(description = "why the head cannot be built, and what to do") @Nullable String problem,
    @Schema(description = "the newest commit that was fetched; absent before the first one")
        @Nullable CommitView commit) {
  static RequestView of(GitRequest request, @Nullable CommitView commit) {
    return new RequestView(
        request.number(),
        request.title(),
        request.author(),
        request.head(),
        request.fork(),
        request.state(),
        request.waitsForApproval(),
        request.askedHead(),
        request.askedBy(),
        request.asked(),
        request.received(),
        request.updated(),
        request.problem(),
        commit);
  }
}
