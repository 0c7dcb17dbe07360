package org.sitaf.core.verdict;

import java.util.Objects;

/**
 * What was executed (SHA-256 in hexadecimal), where and when.
 *
 * @param agent name and version of the agent; empty for a local run
 * @param bridge version of the simulator; empty if none was used
 * @param started ISO 8601, UTC
 * @param finished ISO 8601, UTC
 */
public record Provenance(
    String suite,
    long seed,
    String harness,
    String component,
    String agent,
    String bridge,
    String started,
    String finished) {
  public Provenance {
    Objects.requireNonNull(suite);
    Objects.requireNonNull(harness);
    Objects.requireNonNull(component);
    Objects.requireNonNull(agent);
    Objects.requireNonNull(bridge);
    Objects.requireNonNull(started);
    Objects.requireNonNull(finished);
  }
}
