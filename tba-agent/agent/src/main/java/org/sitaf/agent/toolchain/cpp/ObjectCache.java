package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * Object files by the digest of all that decides about them, so that of a changed component only
 * what changed is compiled again. Several processes may use it at once.
 */
record ObjectCache(Path folder) {
  /** Object files of a harness are some hundred kilobytes. */
  private static final int KEPT = 400;

  /**
   * Copies a file of a compilation to a place; false where there is none of that digest.
   *
   * @param kind extension of the file, such as {@code .o}
   */
  boolean fetch(String digest, String kind, Path file) throws IOException {
    Path kept = folder.resolve(digest + kind);
    try {
      Files.copy(kept, file, StandardCopyOption.REPLACE_EXISTING);
      Files.setLastModifiedTime(kept, FileTime.fromMillis(System.currentTimeMillis()));
      return true;
    } catch (NoSuchFileException e) {
      return false;
    }
  }

  /** Keeps such a file, and forgets those that were not asked for the longest. */
  void keep(String digest, String kind, Path file) throws IOException {
    Files.createDirectories(folder);
    Path fresh = Files.createTempFile(folder, "new", ".part");
    Files.copy(file, fresh, StandardCopyOption.REPLACE_EXISTING);
    Files.move(fresh, folder.resolve(digest + kind), StandardCopyOption.ATOMIC_MOVE);
    List<Path> files;
    try (Stream<Path> all = Files.list(folder)) {
      files = all.sorted(Comparator.comparing(ObjectCache::age)).toList();
    }
    for (Path old : files.subList(0, Math.max(0, files.size() - KEPT))) {
      Files.deleteIfExists(old);
    }
  }

  private static FileTime age(Path file) {
    try {
      return Files.getLastModifiedTime(file);
    } catch (IOException e) {
      return FileTime.fromMillis(0);
    }
  }
}
