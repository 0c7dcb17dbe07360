package org.sitaf.agent.executor;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.verdict.CaseResult;

/**
 * What an execution brought.
 *
 * @param results of the cases that were executed, each once, not yet judged by post-conditions
 * @param reasonOfRest why the other cases were not executed; empty where there are none
 * @param suspicions why the results are not to be trusted; empty where they are
 */
public record Execution(List<CaseResult> results, String reasonOfRest, List<String> suspicions) {
  public Execution {
    results = List.copyOf(results);
    Objects.requireNonNull(reasonOfRest);
    suspicions = List.copyOf(suspicions);
  }
}
