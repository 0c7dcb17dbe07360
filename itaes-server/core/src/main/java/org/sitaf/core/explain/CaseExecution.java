package org.sitaf.core.explain;

import java.util.List;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.verdict.CaseResult;

/** Executes cases that a suite does not contain. */
@FunctionalInterface
public interface CaseExecution {
  /**
   * Executes cases.
   *
   * @return one result for each case, in their order
   * @throws InterruptedException if the search is cancelled
   */
  List<CaseResult> execute(List<TestCase> cases) throws InterruptedException;
}
