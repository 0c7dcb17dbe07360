package org.sitaf.core.flaky;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.RecordedValues;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/**
 * One execution of a case, without its times.
 *
 * @param values outputs, calls, steps, and the error if there is one
 * @param outOfTime whether it ended by the time limit of the machine's clock
 * @param seconds how long the call took; 0 if it did not end
 * @param signals null if there are none
 */
record CaseDigest(
    Verdict verdict,
    String values,
    boolean outOfTime,
    double seconds,
    @Nullable SignalDigest signals) {
  private static final double MICROS_PER_SECOND = 1e6;

  /** The agent's message about a case that it ended. */
  private static final String TIME_LIMIT = "no answer within ";

  CaseDigest {
    Objects.requireNonNull(verdict);
    Objects.requireNonNull(values);
  }

  static CaseDigest of(CaseResult result, @Nullable SignalDigest signals) {
    boolean error = result.verdict() == Verdict.ERROR;
    return new CaseDigest(
        result.verdict(),
        RecordedValues.of(result),
        error && result.message().startsWith(TIME_LIMIT),
        result.time() == null ? 0 : result.micros().orElse(0) / MICROS_PER_SECOND,
        signals);
  }

  boolean isEqual(CaseDigest other) {
    return verdict == other.verdict && values.equals(other.values);
  }
}
