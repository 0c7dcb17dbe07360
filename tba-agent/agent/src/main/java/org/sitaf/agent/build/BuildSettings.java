package org.sitaf.agent.build;

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
 */
public record BuildSettings(
    Simulator simulator,
    Toolchains toolchains,
    Sandbox sandbox,
    boolean coverage,
    String agent,
    @Nullable RecordingOrder recordings) {
  public BuildSettings {
    Objects.requireNonNull(simulator);
    Objects.requireNonNull(toolchains);
    Objects.requireNonNull(sandbox);
    Objects.requireNonNull(agent);
  }

  /** Without recordings. */
  public BuildSettings(
      Simulator simulator, Toolchains toolchains, Sandbox sandbox, boolean coverage, String agent) {
    this(simulator, toolchains, sandbox, coverage, agent, null);
  }

  /** The same machine, for a build that is recorded. */
  public BuildSettings recording(RecordingOrder order) {
    return new BuildSettings(simulator, toolchains, sandbox, coverage, agent, order);
  }
}
