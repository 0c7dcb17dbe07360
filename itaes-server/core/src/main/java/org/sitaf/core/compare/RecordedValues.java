package org.sitaf.core.compare;

import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/** What an execution of a case recorded, without its times: equal texts are equal executions. */
public final class RecordedValues {
  private RecordedValues() {}

  /** Outputs, calls, steps, and the error if there is one. */
  public static String of(CaseResult result) {
    StringBuilder values = new StringBuilder();
    values.append(result.actual()).append(result.calls());
    result.steps().forEach(s -> values.append(s.call()).append(s.actual()).append(s.verdict()));
    if (result.verdict() == Verdict.ERROR) {
      values.append(ErrorText.ofMessage(result.message()));
    }
    return values.toString();
  }
}
