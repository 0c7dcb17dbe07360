package org.sitaf.core.campaign;

import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;

/**
 * What was observed in a case.
 *
 * @param trace all signals; null if there are none
 */
public record Observed(CaseResult result, @Nullable Trace trace) {
  public Observed {
    Objects.requireNonNull(result);
  }

  /** The samples of a signal after the call; empty if it was not sampled. */
  Optional<double[]> signal(String name) {
    Trace sampled = trace;
    if (sampled == null || !sampled.names().contains(name)) {
      return Optional.empty();
    }
    return Optional.of(sampled.columns().get(sampled.names().indexOf(name)));
  }
}
