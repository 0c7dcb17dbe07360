package org.sitaf.agent.build;

/**
 * How many signals of cases are kept: those of recorded cases, and of cases that violate a
 * trajectory condition.
 *
 * @param maxCases at least 0
 * @param maxBytes limit for all cases together, at least 0
 */
public record SignalLimits(int maxCases, long maxBytes) {
  public SignalLimits {
    if (maxCases < 0 || maxBytes < 0) {
      throw new IllegalArgumentException("limits of signals must not be negative");
    }
  }
}
