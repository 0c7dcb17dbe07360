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
 * Files in a folder that other people's code wrote to, once none of its processes is left: only
 * regular ones, found without following links, of a bounded depth, number and size.
 */
public final class LeftFiles {
  private static final int DEPTH = 40;
  private static final int MOST_LOOKED_AT = 100_000;

  private LeftFiles() {}

  /**
   * The files of a folder and those below it, in the order of their paths.
   *
   * @param wanted which ones
   * @param most so many at most
   * @throws IOException when there are more, or none because the folder cannot be looked through
   */
  public static List<Path> in(Path folder, Predicate<Path> wanted, int most) throws IOException {
    List<Path> found = new ArrayList<>();
    List<IOException> problems = new ArrayList<>();
    Files.walkFileTree(
        folder,
        EnumSet.noneOf(FileVisitOption.class),
        DEPTH,
        new SimpleFileVisitor<>() {
          private int seen;

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            if (++seen > MOST_LOOKED_AT) {
              throw new IOException("there are more than " + MOST_LOOKED_AT + " files");
            }
            if (attributes.isRegularFile() && wanted.test(file)) {
              found.add(file);
              if (found.size() > most) {
                throw new IOException("there are more than " + most + " files of its kind");
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
          public FileVisitResult postVisitDirectory(Path passed, @Nullable IOException problem) {
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
   * A file's content.
   *
   * @throws IOException when it is no regular file, or longer
   */
  public static byte[] read(Path file, int mostBytes) throws IOException {
    BasicFileAttributes attributes =
        Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    if (!attributes.isRegularFile()) {
      throw new IOException(file.getFileName() + " is no regular file");
    }
    try (InputStream in =
        Files.newInputStream(file, StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
      byte[] content = in.readNBytes(mostBytes);
      if (in.read() >= 0) {
        throw new IOException(file.getFileName() + " has more than " + mostBytes + " bytes");
      }
      return content;
    }
  }
}
