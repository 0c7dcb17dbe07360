package org.sitaf.agent.spool;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToLongFunction;

/**
 * The bounds of a cache on disk, whose least recently used entries are removed first. An entry is a
 * file or a folder; its modification time says when it was last used. Other processes may use and
 * remove entries at the same time.
 *
 * @param maxBytes of all entries together
 * @param maxEntries their number
 */
public record LeastRecentlyUsed(long maxBytes, int maxEntries) {

  /** Removes an entry. */
  @FunctionalInterface
  public interface Removal {
    /** Removes it; an entry that is not there is removed already. */
    void remove(Path entry) throws IOException;
  }

  /** Marks an entry as used now. */
  public static void touch(Path entry) throws IOException {
    Files.setLastModifiedTime(entry, FileTime.from(Instant.now()));
  }

  /** Entries, the one that was used last first. */
  public static List<Path> newestFirst(Collection<Path> entries) {
    // Read once: another process may use an entry while they are sorted.
    Map<Path, FileTime> used = new HashMap<>();
    entries.forEach(entry -> used.put(entry, used(entry)));
    return used.entrySet().stream()
        .sorted(
            Map.Entry.<Path, FileTime>comparingByValue()
                .reversed()
                .thenComparing(Map.Entry.comparingByKey()))
        .map(Map.Entry::getKey)
        .toList();
  }

  /**
   * Removes entries until the rest is within the bounds. The entry that was used last stays,
   * however large it is.
   *
   * @param bytes the size of an entry
   */
  public void shrink(Collection<Path> entries, ToLongFunction<Path> bytes, Removal removal)
      throws IOException {
    long sum = 0;
    int count = 0;
    for (Path entry : newestFirst(entries)) {
      sum += bytes.applyAsLong(entry);
      count++;
      if (count > 1 && (sum > maxBytes || count > maxEntries)) {
        removal.remove(entry);
      }
    }
  }

  private static FileTime used(Path entry) {
    try {
      return Files.getLastModifiedTime(entry, LinkOption.NOFOLLOW_LINKS);
    } catch (IOException e) {
      return FileTime.from(Instant.EPOCH);
    }
  }
}
