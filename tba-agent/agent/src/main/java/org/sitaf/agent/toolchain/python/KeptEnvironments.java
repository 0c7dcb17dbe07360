package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.agent.spool.LeastRecentlyUsed;
import org.sitaf.agent.spool.SharedCache;

/**
 * The environments in a cache, of which those that were used least recently are removed when they
 * take too much space. One that was used lately stays: a build of any process may run in it.
 *
 * @param maxBytes of all environments together, as far as they are not in use
 */
record KeptEnvironments(SharedCache cache, long maxBytes, Clock clock) {
  /** Longer than any build, also one that is debugged. */
  private static final Duration IN_USE = Duration.ofDays(2);

  private static final Pattern NAME = Pattern.compile("[0-9a-f]{24}");

  /** File with the size of an entry, which is not counted again each time. */
  private static final String SIZE = "bytes";

  /** Writes the size of an entry into its folder. */
  static void measure(Path entry) throws IOException {
    Files.writeString(entry.resolve(SIZE), Long.toString(count(entry)), StandardCharsets.UTF_8);
  }

  /** Marks an environment as used now. */
  void use(String name) {
    try {
      LeastRecentlyUsed.touch(cache.entry(name));
    } catch (IOException e) {
      // It belongs to another user, who keeps its cache small.
    }
  }

  /** Removes environments until the rest is small enough. */
  void shrink() throws IOException {
    List<Path> entries;
    try (Stream<Path> all = Files.list(cache.directory())) {
      entries =
          all.filter(entry -> NAME.matcher(entry.getFileName().toString()).matches()).toList();
    }
    Instant unused = clock.instant().minus(IN_USE);
    new LeastRecentlyUsed(maxBytes, Integer.MAX_VALUE)
        .shrink(
            entries,
            KeptEnvironments::size,
            entry -> {
              if (Files.getLastModifiedTime(entry).toInstant().isBefore(unused)) {
                cache.remove(entry.getFileName().toString());
              }
            });
  }

  private static long size(Path entry) {
    try {
      return Long.parseLong(Files.readString(entry.resolve(SIZE)).strip());
    } catch (IOException | NumberFormatException e) {
      return count(entry);
    }
  }

  private static long count(Path entry) {
    try (Stream<Path> files = Files.walk(entry)) {
      return files
          .filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS))
          .mapToLong(file -> file.toFile().length())
          .sum();
    } catch (IOException | UncheckedIOException e) {
      // Another process removed it.
      return 0;
    }
  }
}
