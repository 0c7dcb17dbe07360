package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Checks the free space of the disk that holds a folder.
 *
 * @param minFreeBytes below this the disk counts as full
 */
public record FreeSpace(Path directory, long minFreeBytes) {
  private static final long MIB = 1 << 20;

  /**
   * The check for a running build: if less is free, a failure is blamed on the disk and not on the
   * user's files.
   */
  public static FreeSpace ofBuild(Path directory) {
    return new FreeSpace(directory, MIB);
  }

  /** A message if the disk is full; empty if it is not. */
  public String whyFull() {
    try {
      long free = Files.getFileStore(directory).getUsableSpace();
      return free >= minFreeBytes
          ? ""
          : "its disk has only %d MiB left, but %d MiB are needed"
              .formatted(free / MIB, minFreeBytes / MIB);
    } catch (IOException e) {
      return "the free space of its disk is unknown: " + e.getMessage();
    }
  }

  /**
   * Requires free space.
   *
   * @throws IOException if the disk is full
   */
  public void require() throws IOException {
    String full = whyFull();
    if (!full.isEmpty()) {
      throw new IOException("this machine cannot continue: " + full);
    }
  }
}
