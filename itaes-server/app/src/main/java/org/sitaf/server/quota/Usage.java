package org.sitaf.server.quota;

import io.swagger.v3.oas.annotations.media.Schema;

/** A user's usage and limits. */
@Schema(name = "Usage")
record Usage(
    @Schema(description = "size of the distinct files of the user's activities and builds")
        long bytes,
    long maxBytes,
    int activities,
    int maxActivities,
    int suites,
    int maxSuites,
    @Schema(description = "unfinished builds") int openBuilds,
    int maxOpenBuilds) {}
