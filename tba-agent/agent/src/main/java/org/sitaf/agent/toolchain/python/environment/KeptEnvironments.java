package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.agent.spool.LeastRecentlyUsed;
import org.sitaf.agent.spool.SharedCache;

/**
 * The environments in a cache, of which those that were used least recently are removed when they
 * take too much space, and the unpacked wheels that no environment has any more. What was used
 * lately stays: a build of any process may run in it.
 *
 * @param maxBytes of all environments and wheels together, as far as they are not in use
 */
record KeptEnvironments(SharedCache cache, long maxBytes, Clock clock) {
  /** Longer than any build, also one that is debugged. */
  private static final Duration IN_USE = Duration.ofDays(2);

  private static final Pattern ENVIRONMENT = Pattern.compile("[0-9a-f]{24}");
  private static final Pattern WHEEL = Pattern.compile(UnpackedWheels.PREFIX + "[0-9a-f]{24}");

  /** File with the size of an entry, which is not counted again each time. */
  private static final String SIZE = "bytes";

  /** Writes the size of an entry, without files that other entries have too, into its folder. */
  static void measure(Path entry) throws IOException {
    Files.writeString(entry.resolve(SIZE), Long.toString(count(entry)), StandardCharsets.UTF_8);
  }

  /** Marks an entry as used now. */
  static void use(Path entry) {
    try {
      LeastRecentlyUsed.touch(entry);
    } catch (IOException e) {
      // It belongs to another user, who keeps its cache small.
    }
  }

  /** Removes environments, and wheels that none has, until the rest is small enough. */
  void shrink() throws IOException {
    List<Path> wheels = new ArrayList<>(entries(WHEEL));
    List<Path> environments = new ArrayList<>(LeastRecentlyUsed.newestFirst(entries(ENVIRONMENT)));
    Collections.reverse(environments);
    long bytes = 0;
    for (Path entry : Stream.concat(wheels.stream(), environments.stream()).toList()) {
      bytes += size(entry);
    }
    if (bytes > maxBytes) {
      bytes -= removeUnused(wheels);
    }
    // The one that was used last stays, however large it is.
    for (Path environment : environments.subList(0, Math.max(0, environments.size() - 1))) {
      if (bytes <= maxBytes) {
        return;
      }
      if (!isInUse(environment)) {
        bytes -= size(environment);
        remove(environment);
        bytes -= removeUnused(wheels);
      }
    }
  }

  /** Removes the wheels of which no environment has a file; returns their size. */
  private long removeUnused(List<Path> wheels) throws IOException {
    long bytes = 0;
    for (Path wheel : List.copyOf(wheels)) {
      if (!isInUse(wheel) && !isShared(wheel)) {
        bytes += size(wheel);
        remove(wheel);
        wheels.remove(wheel);
      }
    }
    return bytes;
  }

  private List<Path> entries(Pattern name) throws IOException {
    try (Stream<Path> all = Files.list(cache.directory())) {
      return all.filter(entry -> name.matcher(entry.getFileName().toString()).matches()).toList();
    }
  }

  private void remove(Path entry) throws IOException {
    cache.remove(entry.getFileName().toString());
  }

  private boolean isInUse(Path entry) {
    try {
      Instant used = Files.getLastModifiedTime(entry).toInstant();
      return !used.isBefore(clock.instant().minus(IN_USE));
    } catch (IOException e) {
      // Another process removed it.
      return true;
    }
  }

  private static boolean isShared(Path wheel) {
    try (Stream<Path> files = Files.walk(wheel.resolve(UnpackedWheels.TREE))) {
      return files.anyMatch(file -> isRegular(file) && isLinked(file));
    } catch (IOException | UncheckedIOException e) {
      return false;
    }
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
          .filter(file -> isRegular(file) && !isLinked(file))
          .mapToLong(file -> file.toFile().length())
          .sum();
    } catch (IOException | UncheckedIOException e) {
      // Another process removed it.
      return 0;
    }
  }

  private static boolean isRegular(Path file) {
    return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
  }

  /** Whether the file has another name, in another entry. */
  private static boolean isLinked(Path file) {
    try {
      return (int) Files.getAttribute(file, "unix:nlink", LinkOption.NOFOLLOW_LINKS) > 1;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
