package org.sitaf.server.build;

import jakarta.persistence.Embeddable;
import jakarta.persistence.EnumType;
import jakarta.persistence.Enumerated;
import java.time.Instant;

/**
 * A change of a build's state.
 *
 * @param attempt number of the attempt, from 1; 0 before the first
 */
@Embeddable
public record Transition(
    int attempt, @Enumerated(EnumType.STRING) BuildState state, Instant atTime, String cause) {
  private static final int MAX_CAUSE = 1000;

  public Transition {
    cause = BuildFailure.cut(cause, MAX_CAUSE);
  }
}
