package org.sitaf.agent.compiler;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.spool.LeastRecentlyUsed;
import org.sitaf.agent.spool.SharedCache;

/**
 * A cache of compiled applications, one folder per key.
 *
 * @param shared shared by several agents and commands
 * @param limitBytes limit for the size of all entries
 */
record CompileCache(SharedCache shared, long limitBytes) {
  private static final Pattern KEY = Pattern.compile("[0-9a-f]{64}");
  private static final int MOST_ENTRIES = 500;
  private static final int DEEPEST = 60;
  private static final int MOST_FILES = 100_000;
  private static final String CONTENT = "content";
  private static final String DIGEST = "sha256";

  /** Checks whether an earlier result is still valid. */
  @FunctionalInterface
  interface Check {
    boolean isCurrent(Path compiled) throws IOException;
  }

  /** Copies an entry into an empty folder; returns false if it is missing, outdated or damaged. */
  boolean restore(String key, Path output, Check check) throws IOException {
    requireKey(key);
    Path entry = shared.entry(key);
    if (!Files.isDirectory(entry)) {
      return false;
    }
    try {
      boolean current = check.isCurrent(entry.resolve(CONTENT));
      if (current) {
        LeastRecentlyUsed.touch(entry);
        copy(entry.resolve(CONTENT), output);
        current = TreeDigest.of(output).equals(Files.readString(entry.resolve(DIGEST)));
      }
      if (!current) {
        empty(output);
        shared.remove(key);
      }
      return current;
    } catch (IOException | UncheckedIOException e) {
      // Another process removed the entry, so the application is compiled.
      empty(output);
      return false;
    }
  }

  /**
   * Adds a copy of a result, and removes the least recently used entries.
   *
   * @throws IOException also if the folder contains anything but files and folders
   */
  void keep(String key, Path output) throws IOException {
    requireKey(key);
    try (SharedCache.Draft draft = shared.draft()) {
      Path content = draft.folder().resolve(CONTENT);
      copy(output, content);
      Files.writeString(draft.folder().resolve(DIGEST), TreeDigest.of(content));
      draft.addAs(key);
    } catch (OddFileException | UncheckedIOException e) {
      // An application with such output is compiled each time.
      return;
    }
    shrink();
  }

  private void shrink() throws IOException {
    List<Path> kept;
    try (Stream<Path> entries = Files.list(shared.directory())) {
      kept =
          entries.filter(entry -> KEY.matcher(entry.getFileName().toString()).matches()).toList();
    }
    new LeastRecentlyUsed(limitBytes, MOST_ENTRIES)
        .shrink(
            kept,
            entry -> size(entry.resolve(CONTENT)),
            entry -> shared.remove(entry.getFileName().toString()));
  }

  private static void requireKey(String key) {
    if (!KEY.matcher(key).matches()) {
      throw new IllegalArgumentException("'" + key + "' is not a valid key");
    }
  }

  private static long size(Path entry) {
    try (Stream<Path> files = Files.walk(entry)) {
      return files.filter(Files::isRegularFile).mapToLong(file -> file.toFile().length()).sum();
    } catch (IOException | UncheckedIOException e) {
      return 0;
    }
  }

  /**
   * Copies the untrusted output of a compiler: regular files, and links to files in the same
   * folder.
   */
  private static void copy(Path from, Path to) throws IOException {
    Path root = from.toRealPath();
    int count = 0;
    try (Stream<Path> files = Files.walk(from, DEEPEST)) {
      for (Path file : (Iterable<Path>) files::iterator) {
        Path inside = from.relativize(file);
        Path target = to.resolve(inside.toString());
        if (++count > MOST_FILES || inside.getNameCount() == DEEPEST) {
          throw new OddFileException(inside + " exceeds the limits for files and depth");
        } else if (Files.isDirectory(file, LinkOption.NOFOLLOW_LINKS)) {
          Files.createDirectories(target);
        } else if (Files.isRegularFile(file) && file.toRealPath().startsWith(root)) {
          Files.copy(file, target, StandardCopyOption.COPY_ATTRIBUTES);
        } else {
          throw new OddFileException(inside + " is neither a folder nor a regular file");
        }
      }
    }
  }

  /** A file that no compiler writes. */
  private static final class OddFileException extends IOException {
    private static final long serialVersionUID = 1L;

    OddFileException(String message) {
      super(message);
    }
  }

  /**
   * Empties the folder without replacing it, because a process that was started early may see it.
   */
  private static void empty(Path folder) throws IOException {
    List<Path> inside;
    try (Stream<Path> files = Files.list(folder)) {
      inside = files.toList();
    }
    for (Path file : inside) {
      Folders.delete(file);
    }
  }
}
