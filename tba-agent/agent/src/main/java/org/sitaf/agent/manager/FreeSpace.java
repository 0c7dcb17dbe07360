package org.sitaf.agent.manager;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Whether the agent's disk has room for another build. */
record FreeSpace(Path directory, long minFreeBytes) {
  private static final long MIB = 1 << 20;

  /** Why no new build can be taken; empty when one can. */
  String whyFull() {
    try {
      long free = Files.getFileStore(directory).getUsableSpace();
      return free >= minFreeBytes
          ? ""
          : "its disk has only %d MiB left, %d are needed"
              .formatted(free / MIB, minFreeBytes / MIB);
    } catch (IOException e) {
      return "its disk cannot be asked for room: " + e.getMessage();
    }
  }
}
