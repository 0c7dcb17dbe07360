package org.sitaf.server.build;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * An attempt, as shown to users.
 *
 * @param finished null while the attempt is running
 */
public record AttemptSummary(
    int no, String agent, BuildState state, Instant leased, @Nullable Instant finished) {}
