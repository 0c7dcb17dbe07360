package org.sitaf.server.build.agent;

import org.springframework.stereotype.Component;

/** The memory for all that agents send in parts. */
@Component
class PartsMemory {
  /** Of what the server has. */
  private static final int SHARE = 6;

  private long free = Runtime.getRuntime().maxMemory() / SHARE;

  /** Whether there was so much, which is taken then. */
  synchronized boolean take(long bytes) {
    if (bytes > free) {
      return false;
    }
    free -= bytes;
    return true;
  }

  synchronized void giveBack(long bytes) {
    free += bytes;
  }
}
