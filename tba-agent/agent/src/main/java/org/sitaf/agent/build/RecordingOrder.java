package org.sitaf.agent.build;

import java.nio.file.Path;
import java.util.Objects;
import org.sitaf.core.verdict.Verdict;

/**
 * Of which cases it is kept what moved in the simulation, and how much of it at most.
 *
 * @param folder where {@code NO.glb} go; created when it is needed
 * @param maxRecordings at least 0
 * @param maxBytes of all recordings together, at least 0
 */
public record RecordingOrder(Path folder, Cases cases, int maxRecordings, long maxBytes) {
  /** Which cases. */
  public enum Cases {
    /** Those that end as FAIL or ERROR. */
    FAILED,
    ALL;

    boolean include(Verdict verdict) {
      return this == ALL || verdict == Verdict.FAIL || verdict == Verdict.ERROR;
    }
  }

  public RecordingOrder {
    Objects.requireNonNull(folder);
    Objects.requireNonNull(cases);
    if (maxRecordings < 0 || maxBytes < 0) {
      throw new IllegalArgumentException("the bounds of recordings must not be negative");
    }
  }
}
