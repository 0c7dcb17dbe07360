package org.sitaf.agent.simulation;

import java.util.Objects;

/**
 * A world that a simulator has compiled.
 *
 * @param stepNanos length of a simulation step
 */
record CompiledWorld(String digest, long stepNanos) {
  CompiledWorld {
    Objects.requireNonNull(digest);
  }
}
