package org.sitaf.server.access.enrolment;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * What lets agents in for the first time.
 *
 * @param agentOrNull the only agent that may use it; null for any that is not known yet
 * @param usesLeft how many agents it still lets in
 */
public record Enrolment(
    String id,
    @Nullable String agentOrNull,
    int usesLeft,
    Instant created,
    String createdBy,
    Instant expires) {
  /** The only agent that may use it; absent for any that is not known yet. */
  public Optional<String> agent() {
    return Optional.ofNullable(agentOrNull);
  }
}
