package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Whether a folder's disk has room.
 *
 * @param minFreeBytes with less than this it is full
 */
public record FreeSpace(Path directory, long minFreeBytes) {
  private static final long MIB = 1 << 20;

  /**
   * Of a build at work: what fails on a disk with less room than this fails for want of it, and
   * says nothing about the user's files.
   */
  public static FreeSpace ofBuild(Path directory) {
    return new FreeSpace(directory, MIB);
  }

  /** Why the disk takes nothing more; empty when it does. */
  public String whyFull() {
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

  /**
   * Makes sure that there is room.
   *
   * @throws IOException when there is none
   */
  public void require() throws IOException {
    String full = whyFull();
    if (!full.isEmpty()) {
      throw new IOException("this machine cannot go on: " + full);
    }
  }
}
