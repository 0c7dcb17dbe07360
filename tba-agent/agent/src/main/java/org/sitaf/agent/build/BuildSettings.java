package org.sitaf.agent.build;

import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.Toolchains;

/**
 * What builds need of the machine that runs them.
 *
 * @param simulator where each build gets its own; the caller closes it
 * @param sandbox in which tools and test applications run
 * @param coverage whether builds say which lines of the component they reached, where the
 *     language's tool is there
 * @param agent name and version of the agent for the provenance; empty for a local run
 * @param recordings what is kept of what moves in the cases; null for nothing
 * @param atMost what a build may take, whatever its cases ask for
 */
public record BuildSettings(
    Simulator simulator,
    Toolchains toolchains,
    Sandbox sandbox,
    boolean coverage,
    String agent,
    @Nullable RecordingOrder recordings,
    Duration atMost) {
  /** What a build may take where nobody says anything else. */
  public static final Duration LONGEST = Duration.ofHours(12);

  public BuildSettings {
    Objects.requireNonNull(simulator);
    Objects.requireNonNull(toolchains);
    Objects.requireNonNull(sandbox);
    Objects.requireNonNull(agent);
    if (atMost.isZero() || atMost.isNegative()) {
      throw new IllegalArgumentException("a build needs time");
    }
  }

  /** Without recordings, and with the usual limit of time. */
  public BuildSettings(
      Simulator simulator, Toolchains toolchains, Sandbox sandbox, boolean coverage, String agent) {
    this(simulator, toolchains, sandbox, coverage, agent, null, LONGEST);
  }

  /** The same machine, for a build that is recorded. */
  public BuildSettings recording(RecordingOrder order) {
    return new BuildSettings(simulator, toolchains, sandbox, coverage, agent, order, atMost);
  }

  /** The same machine, with another limit for a build. */
  public BuildSettings within(Duration limit) {
    return new BuildSettings(simulator, toolchains, sandbox, coverage, agent, recordings, limit);
  }
}
