package org.sitaf.agent.build;

import java.nio.file.Path;
import java.util.Objects;
import org.sitaf.core.verdict.Verdict;

/**
 * Which cases of a build are recorded, and how much at most.
 *
 * @param folder folder of the files {@code NO.glb}; created when needed
 * @param maxRecordings at least 0
 * @param maxBytes limit for all recordings together, at least 0
 */
public record RecordingOrder(Path folder, Cases cases, int maxRecordings, long maxBytes) {
  /** Which cases are recorded. */
  public enum Cases {
    /** Those with the verdict FAIL or ERROR. */
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
      throw new IllegalArgumentException("limits of recordings must not be negative");
    }
  }
}
