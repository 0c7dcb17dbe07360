package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;

/**
 * Folders by name, which several agents and commands share without locks: an entry is made aside
 * and comes by renaming, and goes by renaming, so that it is there whole or not at all.
 *
 * @param directory created when it is needed
 */
public record SharedCache(Path directory) {
  private static final String COMES = "new";
  private static final String GOES = "old";

  /**
   * Who makes or deletes an entry is done within minutes, since compilers and installers have a
   * limit of two. What has been aside for longer than this was left by a process that was killed.
   * Age decides, not a lock, because this must hold between processes of several users as well.
   */
  private static final Duration ABANDONED = Duration.ofHours(1);

  /** Where the entry of a name lies, or would. */
  public Path entry(String name) {
    return directory.resolve(name);
  }

  /**
   * An empty folder aside, to be filled. Whoever begins one deletes what killed processes left
   * first: only who begins one can leave one, so that what is left does not grow.
   */
  public Draft draft() throws IOException {
    Files.createDirectories(directory);
    deleteAbandoned();
    return new Draft(Files.createTempDirectory(directory, COMES));
  }

  /** Removes an entry, whoever else may be about to. */
  public void remove(String name) throws IOException {
    Path aside = Files.createTempDirectory(directory, GOES);
    try {
      Files.move(entry(name), aside.resolve("entry"), StandardCopyOption.ATOMIC_MOVE);
    } catch (IOException e) {
      // Somebody else was faster.
    }
    Folders.delete(aside);
  }

  private void deleteAbandoned() throws IOException {
    Instant before = Instant.now().minus(ABANDONED);
    List<Path> aside;
    try (Stream<Path> all = Files.list(directory)) {
      aside = all.filter(SharedCache::isAside).toList();
    }
    for (Path folder : aside) {
      try {
        if (Files.getLastModifiedTime(folder).toInstant().isBefore(before)) {
          Folders.delete(folder);
        }
      } catch (IOException e) {
        // Another user's, or somebody else is deleting it.
      }
    }
  }

  private static boolean isAside(Path folder) {
    String name = folder.getFileName().toString();
    return name.startsWith(COMES) || name.startsWith(GOES);
  }

  /** An entry in the making; what has not become one is deleted. */
  public final class Draft implements AutoCloseable {
    private final Path folder;

    private Draft(Path folder) {
      this.folder = folder;
    }

    /** Where what the entry is to hold is put. */
    public Path folder() {
      return folder;
    }

    /** Makes it the entry of a name, unless somebody else has added the same meanwhile. */
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
