package org.sitaf.runtime;

import org.jspecify.annotations.Nullable;

/**
 * Holds what {@link Hardware#current()} answers. A process runs one suite, so one place is enough.
 */
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
