package org.sitaf.core.trajectory;

import java.util.Objects;

/**
 * The outcome of one trajectory condition in one case.
 *
 * @param name of the condition
 * @param holds the truth value
 * @param margin the quantitative robustness; may be infinite
 * @param atNanos time relative to the call of the earliest sample that decides the truth value, or
 *     of the last one
 * @param violation describes when and how the condition is violated; empty if it holds
 * @param note why the condition judges nothing although it holds; else empty
 */
public record TrajectoryOutcome(
    String name, boolean holds, double margin, long atNanos, String violation, String note) {
  public TrajectoryOutcome {
    Objects.requireNonNull(name);
    Objects.requireNonNull(violation);
    Objects.requireNonNull(note);
  }
}
