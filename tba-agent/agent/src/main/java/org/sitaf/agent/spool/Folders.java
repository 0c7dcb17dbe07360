package org.sitaf.agent.spool;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Folders as a whole. */
public final class Folders {
  /** Deeper trees are left to a tool that needs no path and no descriptor for each level. */
  private static final int DEPTH = 60;

  private static final Duration PATIENCE = Duration.ofMinutes(5);

  private Folders() {}

  /**
   * Deletes a folder with all that is in it, whatever its depth and the rights of what it holds;
   * links are deleted, not followed. One that is not there is deleted already.
   *
   * @throws IOException when something is left after all
   */
  public static void delete(Path root) throws IOException {
    try {
      deleteShallow(root);
    } catch (IOException e) {
      deleteByTool(root);
    }
  }

  private static void deleteShallow(Path root) throws IOException {
    if (!Files.isDirectory(root, LinkOption.NOFOLLOW_LINKS)) {
      Files.deleteIfExists(root);
      return;
    }
    Files.walkFileTree(
        root,
        EnumSet.noneOf(java.nio.file.FileVisitOption.class),
        DEPTH,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            Files.deleteIfExists(file);
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult postVisitDirectory(Path folder, @Nullable IOException failure)
              throws IOException {
            if (failure != null) {
              throw failure;
            }
            Files.deleteIfExists(folder);
            return FileVisitResult.CONTINUE;
          }
        });
  }

  /** A cancelled build deletes as well: an interrupt waits until that is done. */
  private static void deleteByTool(Path root) throws IOException {
    boolean interrupted = Thread.interrupted();
    try {
      deleteByTool(root, PATIENCE);
    } catch (InterruptedException e) {
      interrupted = true;
      throw (InterruptedIOException) new InterruptedIOException("interrupted").initCause(e);
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /**
   * As {@link #delete}, by programs of the system alone.
   *
   * @param atMost of each program
   */
  static void deleteByTool(Path root, Duration atMost) throws IOException, InterruptedException {
    List<String> remove =
        List.of("rm", "-rf", "--one-file-system", "--", root.toAbsolutePath().toString());
    try {
      SystemTool.run(remove, atMost);
    } catch (IOException e) {
      // Folders of this user that lack rights; none of its processes is left to put a link there.
      SystemTool.run(
          List.of("chmod", "-Rf", "u+rwx", "--", root.toAbsolutePath().toString()), atMost);
      SystemTool.run(remove, atMost);
    }
  }
}
