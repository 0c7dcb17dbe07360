package org.sitaf.core.verdict;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The result of one trajectory condition in one case.
 *
 * @param verdict PASS, FAIL, or ERROR if the condition could not be evaluated
 * @param margin the quantitative robustness, possibly infinite; null with ERROR
 * @param at seconds after the call: the earliest sample that decides the truth value, else the end;
 *     null with ERROR
 */
public record TrajectoryResult(
    String name, Verdict verdict, @Nullable Double margin, @Nullable Double at) {
  public TrajectoryResult {
    Objects.requireNonNull(name);
    Objects.requireNonNull(verdict);
  }
}
