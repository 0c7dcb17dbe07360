package org.sitaf.server.access.enrolment;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * A token with which agents enrol and get their keys.
 *
 * @param agentOrNull the only agent that may use it; null for any agent without a key
 * @param usesLeft how many more agents can enrol with it
 */
public record Enrolment(
    String id,
    @Nullable String agentOrNull,
    int usesLeft,
    Instant created,
    String createdBy,
    Instant expires) {
  /** The only agent that may use it; empty for any agent without a key. */
  public Optional<String> agent() {
    return Optional.ofNullable(agentOrNull);
  }
}
