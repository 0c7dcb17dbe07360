package org.sitaf.runtime;

import org.jspecify.annotations.Nullable;

/** The value of {@link Hardware#current()}. It is static because a process runs a single suite. */
final class CurrentHardware {
  private static volatile @Nullable Hardware hardware;

  private CurrentHardware() {}

  static Hardware get() {
    Hardware current = hardware;
    if (current == null) {
      throw new IllegalStateException(
          "there is no virtual hardware: no test with a simulated world is running"
              + " (does the activity name a world?)");
    }
    return current;
  }

  static void set(@Nullable Hardware current) {
    hardware = current;
  }
}
