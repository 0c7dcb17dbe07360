package org.sitaf.agent.executor;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.DiskLimits;
import org.sitaf.agent.spool.Folders;

/**
 * The folders that a process of a test application writes to.
 *
 * @param coverage used by this process only; null for none
 * @param recording shared with other processes; null for none
 */
record OutputFolders(
    Path working, Path temporary, @Nullable Path coverage, @Nullable Path recording) {

  /**
   * Cleans the folders after the process has ended, so that the next process has room.
   *
   * @param all whether to delete everything; otherwise only folders that exceed their limit
   */
  void makeRoom(boolean all) {
    if (all) {
      empty(working);
      empty(temporary);
    }
    if (coverage != null
        && (all || DiskLimits.COMPONENT.areExceededBy(coverage.toAbsolutePath().getParent()))) {
      empty(coverage);
    }
    if (recording != null && (all || DiskLimits.COMPONENT.areExceededBy(recording))) {
      empty(recording);
    }
  }

  /** Empties a folder without deleting it, because other processes may have it open. */
  private static void empty(Path folder) {
    try (DirectoryStream<Path> inside = Files.newDirectoryStream(folder)) {
      for (Path path : inside) {
        Folders.delete(path);
      }
    } catch (IOException | DirectoryIteratorException e) {
      // Permissions may be missing; the folder is created again when needed.
      replace(folder);
    }
  }

  private static void replace(Path folder) {
    try {
      Folders.delete(folder);
      Files.createDirectories(folder);
    } catch (IOException e) {
      // The next process reports the error.
    }
  }
}
