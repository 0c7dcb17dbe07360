package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Folders by name, shared by several agents and commands without locks: entries appear and
 * disappear by an atomic rename.
 *
 * @param directory created when needed
 * @param earlier another cache, whose entries are used and never changed; null for none
 */
public record SharedCache(Path directory, @Nullable Path earlier) {
  private static final String DRAFT_PREFIX = "new";
  private static final String REMOVED_PREFIX = "old";

  /**
   * Creating or deleting an entry takes minutes at most, because compilers and installers have
   * timeouts. Older temporary folders were left by killed processes. A lock would not work between
   * processes of several users.
   */
  private static final Duration MAX_AGE = Duration.ofHours(1);

  /** A cache without an earlier one. */
  public SharedCache(Path directory) {
    this(directory, null);
  }

  /** An entry that exists, here or in the earlier cache. */
  public Optional<Path> existing(String name) {
    return Stream.concat(Stream.of(directory), Stream.ofNullable(earlier))
        .map(folder -> folder.resolve(name))
        .filter(Files::isDirectory)
        .findFirst();
  }

  /** The path of an entry, whether or not it exists. */
  public Path entry(String name) {
    return directory.resolve(name);
  }

  /**
   * Creates an empty draft of an entry. Deletes temporary folders of killed processes first, so
   * that they cannot accumulate.
   */
  public Draft draft() throws IOException {
    Files.createDirectories(directory);
    deleteAbandoned();
    return new Draft(Files.createTempDirectory(directory, DRAFT_PREFIX));
  }

  /** Removes an entry. Other processes may remove the same entry at the same time. */
  public void remove(String name) throws IOException {
    Path temporary = Files.createTempDirectory(directory, REMOVED_PREFIX);
    try {
      Files.move(entry(name), temporary.resolve("entry"), StandardCopyOption.ATOMIC_MOVE);
    } catch (IOException e) {
      // Another process was faster.
    }
    Folders.delete(temporary);
  }

  private void deleteAbandoned() throws IOException {
    Instant before = Instant.now().minus(MAX_AGE);
    List<Path> temporary;
    try (Stream<Path> all = Files.list(directory)) {
      temporary = all.filter(SharedCache::isTemporary).toList();
    }
    for (Path folder : temporary) {
      try {
        if (Files.getLastModifiedTime(folder).toInstant().isBefore(before)) {
          Folders.delete(folder);
        }
      } catch (IOException e) {
        // It belongs to another user, or another process is deleting it.
      }
    }
  }

  private static boolean isTemporary(Path folder) {
    String name = folder.getFileName().toString();
    return name.startsWith(DRAFT_PREFIX) || name.startsWith(REMOVED_PREFIX);
  }

  /** An entry in preparation; deleted on close unless it was added. */
  public final class Draft implements AutoCloseable {
    private final Path folder;

    private Draft(Path folder) {
      this.folder = folder;
    }

    /** The folder for the content of the entry. */
    public Path folder() {
      return folder;
    }

    /** Adds the entry under a name, unless another process has added it meanwhile. */
    public void addAs(String name) throws IOException {
      try {
        Files.move(folder, entry(name), StandardCopyOption.ATOMIC_MOVE);
      } catch (FileSystemException e) {
        if (!Files.isDirectory(entry(name))) {
          throw e;
        }
      }
    }

    @Override
    public void close() throws IOException {
      Folders.delete(folder);
    }
  }
}
