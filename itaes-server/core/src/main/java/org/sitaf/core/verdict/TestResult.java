package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;

/**
 * The result of a build (paper, Fig. 11).
 *
 * @param coverage null where it was not measured
 */
public record TestResult(
    String name,
    Provenance provenance,
    Summary summary,
    List<CaseParameter> parameters,
    List<CaseResult> cases,
    @Nullable Coverage coverage) {
  public TestResult {
    Objects.requireNonNull(name);
    Objects.requireNonNull(provenance);
    Objects.requireNonNull(summary);
    parameters = List.copyOf(parameters);
    cases = List.copyOf(cases);
  }

  /** The same with what was reached of the component. */
  public TestResult with(Coverage measured) {
    return new TestResult(name, provenance, summary, parameters, cases, measured);
  }
}
