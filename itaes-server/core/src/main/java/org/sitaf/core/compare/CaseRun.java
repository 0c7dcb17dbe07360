package org.sitaf.core.compare;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;

/**
 * One execution of a case.
 *
 * @param record null if the case was not executed
 * @param result its result; its message is the reason if the case was not executed
 * @param signals null if there are none
 */
public record CaseRun(@Nullable CaseRecord record, CaseResult result, @Nullable Trace signals) {
  public CaseRun {
    Objects.requireNonNull(result);
  }

  /** Why there is nothing to compare; empty if the component was called. */
  String notCalled() {
    if (record == null) {
      return result.message().isEmpty() ? "the case was not executed" : result.message();
    }
    return record.outcome() == CaseRecord.Outcome.NOT_CALLED ? record.message() : "";
  }
}
