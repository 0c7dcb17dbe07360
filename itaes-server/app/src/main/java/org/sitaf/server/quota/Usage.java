package org.sitaf.server.quota;

import io.swagger.v3.oas.annotations.media.Schema;

/** What a person uses of the server, and how much of each they may. */
@Schema(name = "Usage")
record Usage(
    @Schema(
            description =
                "of the distinct files of the activities that the person stored last and of the"
                    + " builds that they requested")
        long bytes,
    long maxBytes,
    int activities,
    int maxActivities,
    int suites,
    int maxSuites,
    @Schema(description = "builds that are not over") int openBuilds,
    int maxOpenBuilds) {}
