package org.sitaf.cli.compare;

import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.CaseRun;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;

/**
 * One run of some cases of a model with one version.
 *
 * @param result null if the version could not be run
 * @param problem why it could not be run; empty otherwise
 */
public record Run(
    @Nullable TestResult result,
    Map<Integer, CaseRecord> records,
    Map<Integer, CaseResult> results,
    SignalFiles signals,
    String problem) {
  public Run {
    records = Map.copyOf(records);
    results = Map.copyOf(results);
  }

  /** The execution of a case. */
  public CaseRun of(int no) {
    CaseResult judged = results.get(no);
    if (judged == null) {
      throw new IllegalArgumentException("the run has no case " + no);
    }
    return new CaseRun(records.get(no), judged, signals.read(no));
  }
}
