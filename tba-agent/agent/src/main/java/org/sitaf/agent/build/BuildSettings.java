package org.sitaf.agent.build;

import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.agent.toolchain.debug.DebugOrder;

/**
 * The part of an agent's settings that builds need.
 *
 * @param simulator provides each build with a simulator; closed by the caller
 * @param sandbox for tools and test applications
 * @param coverage whether builds measure line coverage, if the coverage tool is installed
 * @param agent name and version of the agent, for the provenance; empty for a local run
 * @param recordings which cases are recorded; null for none
 * @param signals whether all signals of each case are reported to the listener
 * @param kept limits of the signals that are kept for a server; null for none
 * @param atMost limit for the duration of a build, regardless of its own limits
 * @param variation of its processes; see {@link org.sitaf.agent.toolchain.ProcessPlace}
 * @param debugging the order to debug the first process; null for none
 * @param devices the real devices that builds may use
 */
public record BuildSettings(
    Simulator simulator,
    Toolchains toolchains,
    Sandbox sandbox,
    boolean coverage,
    String agent,
    @Nullable RecordingOrder recordings,
    boolean signals,
    @Nullable SignalLimits kept,
    Duration atMost,
    int variation,
    @Nullable DebugOrder debugging,
    OfferedDevices devices) {
  /** Default limit for the duration of a build. */
  public static final Duration DEFAULT_LIMIT = Duration.ofHours(12);

  /** Limit for the duration of a build that is debugged. */
  public static final Duration DEBUGGING_LIMIT = Duration.ofHours(24);

  public BuildSettings {
    Objects.requireNonNull(simulator);
    Objects.requireNonNull(toolchains);
    Objects.requireNonNull(sandbox);
    Objects.requireNonNull(agent);
    Objects.requireNonNull(devices);
    if (atMost.isZero() || atMost.isNegative()) {
      throw new IllegalArgumentException("the limit of a build's duration must be positive");
    }
  }

  /** Without recordings, and with the default limit. */
  public BuildSettings(
      Simulator simulator, Toolchains toolchains, Sandbox sandbox, boolean coverage, String agent) {
    this(
        simulator,
        toolchains,
        sandbox,
        coverage,
        agent,
        null,
        false,
        null,
        DEFAULT_LIMIT,
        0,
        null,
        OfferedDevices.NONE);
  }

  /** The same settings with real devices. */
  public BuildSettings offering(OfferedDevices offered) {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        coverage,
        agent,
        recordings,
        signals,
        kept,
        atMost,
        variation,
        debugging,
        offered);
  }

  /** The same settings with recordings. */
  public BuildSettings recording(RecordingOrder order) {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        coverage,
        agent,
        order,
        signals,
        kept,
        atMost,
        variation,
        debugging,
        devices);
  }

  /** The same settings with the signals of each case. */
  public BuildSettings withSignals() {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        coverage,
        agent,
        recordings,
        true,
        kept,
        atMost,
        variation,
        debugging,
        devices);
  }

  /** The same settings with signals that are kept for a server. */
  public BuildSettings keeping(SignalLimits limits) {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        coverage,
        agent,
        recordings,
        signals,
        limits,
        atMost,
        variation,
        debugging,
        devices);
  }

  /** The same settings with another limit for the duration. */
  public BuildSettings within(Duration limit) {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        coverage,
        agent,
        recordings,
        signals,
        kept,
        limit,
        variation,
        debugging,
        devices);
  }

  /** The same settings with or without coverage. */
  public BuildSettings withCoverage(boolean measured) {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        measured,
        agent,
        recordings,
        signals,
        kept,
        atMost,
        variation,
        debugging,
        devices);
  }

  /** The same settings with another variation of the processes. */
  public BuildSettings varied(int number) {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        coverage,
        agent,
        recordings,
        signals,
        kept,
        atMost,
        number,
        debugging,
        devices);
  }

  /**
   * The same settings for debugging: without coverage and with enough time to look around. The
   * debugged process runs without a sandbox, because its debugger must reach it.
   */
  public BuildSettings debugged(DebugOrder order) {
    return new BuildSettings(
        simulator,
        toolchains,
        sandbox,
        false,
        agent,
        recordings,
        signals,
        kept,
        DEBUGGING_LIMIT,
        variation,
        order,
        devices);
  }
}
