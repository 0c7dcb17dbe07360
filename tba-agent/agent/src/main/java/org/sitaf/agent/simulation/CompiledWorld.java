package org.sitaf.agent.simulation;

import java.util.Map;
import java.util.Objects;
import org.sitaf.core.activity.hardware.DeviceBackend.Range;

/**
 * A world that a simulator has compiled.
 *
 * @param stepNanos length of a simulation step
 * @param commands limits of the numbers in commands, by device
 */
record CompiledWorld(String digest, long stepNanos, Map<String, Map<String, Range>> commands) {
  CompiledWorld {
    Objects.requireNonNull(digest);
    commands = Map.copyOf(commands);
  }
}
