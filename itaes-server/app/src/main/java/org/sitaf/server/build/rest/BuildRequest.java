package org.sitaf.server.build.rest;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.build.request.AgentWishes;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;

/** Which suite is to be built, and how. */
@Schema(name = "BuildRequest")
record BuildRequest(
    String suiteId,
    @Schema(description = "-100 to 100; higher ones are given to agents first; 0 where absent")
        @Nullable Integer priority,
    @Schema(description = "over how many agents the cases are spread, 1 to 100; 1 where absent")
        @Nullable Integer shards,
    @Schema(
            description =
                "after failures of the infrastructure, 0 to 99; a test that fails is never repeated")
        @Nullable Integer retries,
    @Schema(description = "release of the component's tools, such as 17; any where absent")
        @Nullable String toolchain,
    @Schema(description = "that the agent must have") @Nullable Set<String> labels,
    @Schema(
            description =
                "of which cases it is recorded what moves in the simulation: ALL, the FAILED (and ERROR) ones, or NONE;"
                    + " where absent of ALL of up to 100 cases, of NONE of more")
        @Nullable RecordedCases recordings) {

  BuildOptions options() {
    return new BuildOptions(
        priority == null ? 0 : priority,
        shards == null ? 1 : shards,
        retries,
        new AgentWishes(toolchain == null ? "" : toolchain, labels == null ? Set.of() : labels),
        recordings);
  }
}
