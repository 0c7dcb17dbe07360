package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.suite.CaseParameter;

/** The result of a build (paper, Fig. 11). */
public record TestResult(
    String name,
    Provenance provenance,
    Summary summary,
    List<CaseParameter> parameters,
    List<CaseResult> cases) {
  public TestResult {
    Objects.requireNonNull(name);
    Objects.requireNonNull(provenance);
    Objects.requireNonNull(summary);
    parameters = List.copyOf(parameters);
    cases = List.copyOf(cases);
  }
}
