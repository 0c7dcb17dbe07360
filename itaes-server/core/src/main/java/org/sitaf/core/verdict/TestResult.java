package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;

/**
 * The result of a build (paper, Fig. 11).
 *
 * @param coverage null if not measured
 * @param suspicions reasons not to trust the records of the test application; empty if there are
 *     none
 */
public record TestResult(
    String name,
    Provenance provenance,
    Summary summary,
    List<CaseParameter> parameters,
    List<CaseResult> cases,
    @Nullable Coverage coverage,
    List<String> suspicions) {
  public TestResult {
    Objects.requireNonNull(name);
    Objects.requireNonNull(provenance);
    Objects.requireNonNull(summary);
    parameters = List.copyOf(parameters);
    cases = List.copyOf(cases);
    suspicions = List.copyOf(suspicions);
  }

  /** A result that is not suspect. */
  public TestResult(
      String name,
      Provenance provenance,
      Summary summary,
      List<CaseParameter> parameters,
      List<CaseResult> cases,
      @Nullable Coverage coverage) {
    this(name, provenance, summary, parameters, cases, coverage, List.of());
  }

  /** A copy with coverage. */
  public TestResult with(Coverage measured) {
    return new TestResult(name, provenance, summary, parameters, cases, measured, suspicions);
  }

  /** A copy that is suspect for these reasons. */
  public TestResult withSuspicions(List<String> reasons) {
    return new TestResult(name, provenance, summary, parameters, cases, coverage, reasons);
  }

  /** Whether there are cases, all passed, and the result is not suspect. */
  public boolean allPassed() {
    return summary.total() > 0 && summary.pass() == summary.total() && !isSuspect();
  }

  /** Whether the verdicts cannot be trusted. A suspect result never counts as passed. */
  public boolean isSuspect() {
    return !suspicions.isEmpty();
  }
}
