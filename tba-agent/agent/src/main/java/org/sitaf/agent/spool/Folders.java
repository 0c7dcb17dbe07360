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

/** Operations on folder trees. */
public final class Folders {
  /** Deeper trees are deleted by {@code rm}, which needs no descriptor per level. */
  private static final int MAX_DEPTH = 60;

  private static final Duration DELETE_TIMEOUT = Duration.ofMinutes(5);

  private Folders() {}

  /**
   * Deletes a folder tree of any depth and with any permissions. Links are deleted, not followed. A
   * missing folder is not an error.
   *
   * @throws IOException if something could not be deleted
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
        MAX_DEPTH,
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

  /** Runs to its end even in an interrupted thread, because cancelled builds delete, too. */
  private static void deleteByTool(Path root) throws IOException {
    boolean interrupted = Thread.interrupted();
    try {
      deleteByTool(root, DELETE_TIMEOUT);
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
   * Like {@link #delete}, with system programs only.
   *
   * @param atMost timeout of each program
   */
  static void deleteByTool(Path root, Duration atMost) throws IOException, InterruptedException {
    List<String> remove =
        List.of("rm", "-rf", "--one-file-system", "--", root.toAbsolutePath().toString());
    try {
      SystemTool.run(remove, atMost);
    } catch (IOException e) {
      // Folders without permissions. No process is left that could replace one by a link.
      SystemTool.run(
          List.of("chmod", "-Rf", "u+rwx", "--", root.toAbsolutePath().toString()), atMost);
      SystemTool.run(remove, atMost);
    }
  }
}
