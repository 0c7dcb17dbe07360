package org.sitaf.agent.executor;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.verdict.CaseResult;

/**
 * Result of an execution.
 *
 * @param results one per executed case, before the evaluation of post-conditions
 * @param reasonOfRest why the other cases were not executed; empty if all were
 * @param suspicions reasons why the results cannot be trusted; empty if they can
 */
public record Execution(List<CaseResult> results, String reasonOfRest, List<String> suspicions) {
  public Execution {
    results = List.copyOf(results);
    Objects.requireNonNull(reasonOfRest);
    suspicions = List.copyOf(suspicions);
  }
}
