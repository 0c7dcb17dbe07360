package org.sitaf.agent.analysis;

import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.TestResult;

/**
 * What to analyse.
 *
 * @param analysed the result whose failures are explained; null to score the specification
 * @param maxCases maximum number of further cases
 */
public record AnalysisOrder(@Nullable TestResult analysed, int maxCases) {
  public AnalysisOrder {
    if (maxCases < 0) {
      throw new IllegalArgumentException("the number of further cases must not be negative");
    }
  }
}
