package org.sitaf.server.build;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * An attempt as people see it.
 *
 * @param finished null while an agent works on it
 */
public record PastAttempt(
    int no, String agent, BuildState state, Instant leased, @Nullable Instant finished) {}
