package org.sitaf.core.explain;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.FailureGroup;
import org.sitaf.core.verdict.Verdict;

/** Executes cases beyond the suite, and keeps their results. */
final class FurtherCases {
  private final SuiteValues values;
  private final CaseExecution execution;
  private final int budget;
  private final Map<List<String>, CaseResult> failed = new HashMap<>();
  private int executions;

  FurtherCases(SuiteValues values, CaseExecution execution, int budget) {
    this.values = values;
    this.execution = execution;
    this.budget = budget;
  }

  static Outcome outcome(CaseResult result) {
    boolean failed = result.verdict() == Verdict.FAIL || result.verdict() == Verdict.ERROR;
    return failed ? new Outcome(true, FailureGroup.kind(result)) : Outcome.PASSED;
  }

  int executions() {
    return executions;
  }

  boolean isExhausted() {
    return executions >= budget;
  }

  /** Remembers a failed case. */
  void remember(CaseResult result) {
    if (outcome(result).failed()) {
      failed.put(result.values(), result);
    }
  }

  /** The result of a case that failed. */
  Optional<CaseResult> failed(List<Value> row) {
    return Optional.ofNullable(failed.get(row.stream().map(Value::literal).toList()));
  }

  /**
   * Executes a case; empty if it may not be executed.
   *
   * @throws IllegalStateException if it was not executed
   */
  Optional<CaseResult> execute(List<Value> row) throws InterruptedException {
    Optional<TestCase> testCase = values.testCase(row);
    if (testCase.isEmpty()) {
      return Optional.empty();
    }
    executions++;
    CaseResult result = execution.execute(List.of(testCase.get())).get(0);
    if (result.verdict() == Verdict.DONT) {
      throw new IllegalStateException("a case was not executed: " + result.message());
    }
    remember(result);
    return Optional.of(result);
  }
}
