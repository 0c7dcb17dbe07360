package org.sitaf.agent.spool;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * Files that untrusted code wrote, read after all its processes have ended: only regular files,
 * without following links, limited in depth, number and size.
 */
public final class LeftFiles {
  private static final int MAX_DEPTH = 40;
  private static final int MAX_VISITED = 100_000;

  private LeftFiles() {}

  /**
   * The files of a folder tree, sorted by path.
   *
   * @param wanted which files to return
   * @param maxFiles limit for the number of returned files
   * @throws IOException if there are more, or if none is found because the folder cannot be read
   */
  public static List<Path> in(Path folder, Predicate<Path> wanted, int maxFiles)
      throws IOException {
    List<Path> found = new ArrayList<>();
    List<IOException> problems = new ArrayList<>();
    Files.walkFileTree(
        folder,
        EnumSet.noneOf(FileVisitOption.class),
        MAX_DEPTH,
        new SimpleFileVisitor<>() {
          private int seen;

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            if (++seen > MAX_VISITED) {
              throw new IOException("there are more than " + MAX_VISITED + " files");
            }
            if (attributes.isRegularFile() && wanted.test(file)) {
              found.add(file);
              if (found.size() > maxFiles) {
                throw new IOException("there are more than " + maxFiles + " files of this kind");
              }
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException problem) {
            problems.add(problem);
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult postVisitDirectory(Path directory, @Nullable IOException problem) {
            if (problem != null) {
              problems.add(problem);
            }
            return FileVisitResult.CONTINUE;
          }
        });
    if (found.isEmpty() && !problems.isEmpty()) {
      throw problems.get(0);
    }
    found.sort(null);
    return found;
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it is not a regular file or too long
   */
  public static byte[] read(Path file, int maxBytes) throws IOException {
    BasicFileAttributes attributes =
        Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    if (!attributes.isRegularFile()) {
      throw new IOException(file.getFileName() + " is not a regular file");
    }
    try (InputStream in =
        Files.newInputStream(file, StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
      byte[] content = in.readNBytes(maxBytes);
      if (in.read() >= 0) {
        throw new IOException(file.getFileName() + " has more than " + maxBytes + " bytes");
      }
      return content;
    }
  }
}
