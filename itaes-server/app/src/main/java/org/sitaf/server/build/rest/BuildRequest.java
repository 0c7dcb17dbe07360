package org.sitaf.server.build.rest;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.server.build.request.AgentConstraints;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.BuildSource;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.error.RequestException;

/** A request to build a suite. */
@Schema(name = "BuildRequest")
record BuildRequest(
    String suiteId,
    @Schema(description = "-100 to 100; builds with higher priority run first; default 0")
        @Nullable Integer priority,
    @Schema(description = "number of shards that run in parallel, 1 to 100; default 1")
        @Nullable Integer shards,
    @Schema(
            description =
                "number of retries after infrastructure failures, 0 to 99; failed tests are not"
                    + " retried")
        @Nullable Integer retries,
    @Schema(description = "version of the toolchain, such as 17; default any")
        @Nullable String toolchain,
    @Schema(description = "required labels of the agent") @Nullable Set<String> labels,
    @Schema(
            description =
                "which cases are recorded in the simulation: ALL, FAILED (FAIL and ERROR), or NONE;"
                    + " default ALL for up to 100 cases, otherwise NONE")
        @Nullable RecordedCases recordings,
    @Schema(
            description =
                "id of the commit that is tested, with the suffix -dirty if the files differ from"
                    + " it; at most 100 characters")
        @Nullable String commit,
    @Schema(description = "says what is built, by key; at most 20 of 200 characters")
        @Nullable Map<String, String> buildLabels,
    @Schema(
            description =
                "numbers and ranges of the cases to execute, such as 9,12-20; they keep their"
                    + " numbers; default all")
        @Nullable String cases,
    @Schema(
            description =
                "id of a build of the same suite whose cases that did not pass are executed; not"
                    + " together with cases")
        @Nullable String failedOf,
    @Schema(description = "whether the failures are explained when the build ends; default false")
        @Nullable Boolean explain,
    @Schema(
            description =
                "what a ROS 2 node runs with: INCLUDED, the API that comes along, over simulated"
                    + " time, or SYSTEM, the ROS 2 that is installed on the agent, in real time;"
                    + " default INCLUDED")
        @Nullable RosImplementation ros) {

  BuildSource source() {
    return new BuildSource(
        commit == null || commit.isEmpty() ? null : commit,
        buildLabels == null ? Map.of() : buildLabels);
  }

  BuildOptions options() {
    return new BuildOptions(
        priority == null ? 0 : priority,
        shards == null ? 1 : shards,
        retries,
        new AgentConstraints(
            toolchain == null ? "" : toolchain, labels == null ? Set.of() : labels),
        recordings,
        numbers(),
        Boolean.TRUE.equals(explain),
        ros == null ? RosImplementation.INCLUDED : ros);
  }

  private @Nullable CaseNumbers numbers() {
    if (cases == null) {
      return null;
    }
    if (failedOf != null) {
      throw RequestException.malformed("cases: cannot be given together with failedOf.");
    }
    try {
      return CaseNumbers.parse(cases);
    } catch (IllegalArgumentException e) {
      throw RequestException.malformed("cases: " + e.getMessage() + ".");
    }
  }
}
