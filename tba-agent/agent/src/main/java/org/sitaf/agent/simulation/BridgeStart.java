package org.sitaf.agent.simulation;

import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.ConfinedProcess;

/**
 * The start of a bridge, possibly before a build needs it. Until then its process uses only
 * processor time that nobody else needs.
 */
final class BridgeStart {
  private @Nullable ConfinedProcess process;
  private boolean needed;
  private long neededSince;

  /** Sets the process, once it exists. */
  synchronized void setProcess(ConfinedProcess started) {
    process = started;
    started.setIdle(!needed);
  }

  /** A build waits for the bridge, or uses it. */
  synchronized void need() {
    needed = true;
    neededSince = System.nanoTime();
    if (process != null) {
      process.setIdle(false);
    }
  }

  /** How long a build has needed it; zero if none does. */
  synchronized Duration neededFor() {
    return needed ? Duration.ofNanos(System.nanoTime() - neededSince) : Duration.ZERO;
  }
}
