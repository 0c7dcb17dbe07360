package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.activity.lock.ResolvedPackage;

/**
 * What was executed (SHA-256 in hexadecimal), where and when.
 *
 * @param agent name and version of the agent; empty for a local run
 * @param bridge version of the simulator; empty if none was used
 * @param compiler compiler or interpreter with its version and options
 * @param packages that the component uses, with those that they need
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
    String compiler,
    List<ResolvedPackage> packages,
    String started,
    String finished) {
  public Provenance {
    Objects.requireNonNull(suite);
    Objects.requireNonNull(harness);
    Objects.requireNonNull(component);
    Objects.requireNonNull(agent);
    Objects.requireNonNull(bridge);
    // Stored results of earlier releases have none.
    compiler = compiler == null ? "" : compiler;
    packages = packages == null ? List.of() : List.copyOf(packages);
    Objects.requireNonNull(started);
    Objects.requireNonNull(finished);
  }

  /** A provenance without compiler and packages. */
  public Provenance(
      String suite,
      long seed,
      String harness,
      String component,
      String agent,
      String bridge,
      String started,
      String finished) {
    this(suite, seed, harness, component, agent, bridge, "", List.of(), started, finished);
  }
}
