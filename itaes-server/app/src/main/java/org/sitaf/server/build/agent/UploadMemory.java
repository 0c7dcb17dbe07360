package org.sitaf.server.build.agent;

import org.springframework.stereotype.Component;

/** Limits the memory for chunked uploads of all agents. */
@Component
class UploadMemory {
  /** The uploads may use this fraction of the heap. */
  private static final int HEAP_FRACTION = 6;

  private long free = Runtime.getRuntime().maxMemory() / HEAP_FRACTION;

  /** Reserves memory; returns false if there is not enough. */
  synchronized boolean reserve(long bytes) {
    if (bytes > free) {
      return false;
    }
    free -= bytes;
    return true;
  }

  synchronized void release(long bytes) {
    free += bytes;
  }
}
