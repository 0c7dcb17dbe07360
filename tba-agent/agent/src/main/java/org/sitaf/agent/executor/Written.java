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
 * @param coverage of this process alone, next to those of others; null for none
 * @param recording shared with others at work; null for none
 */
record Written(Path working, Path temporary, @Nullable Path coverage, @Nullable Path recording) {

  /**
   * Sees to it, once the process has ended, that the next one has room: a process ends with what it
   * was ended for, and all of them together fill no disk.
   *
   * @param all whether all that it wrote is to go; else only what is too much
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

  /** Leaves the folder itself, which other processes may have. */
  private static void empty(Path folder) {
    try (DirectoryStream<Path> inside = Files.newDirectoryStream(folder)) {
      for (Path path : inside) {
        Folders.delete(path);
      }
    } catch (IOException | DirectoryIteratorException e) {
      // Its rights may be lacking; who needs it makes it again.
      replace(folder);
    }
  }

  private static void replace(Path folder) {
    try {
      Folders.delete(folder);
      Files.createDirectories(folder);
    } catch (IOException e) {
      // The next process says so, if it cannot work like that.
    }
  }
}
