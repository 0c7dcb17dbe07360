package org.sitaf.server.storage;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.ToLongFunction;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.core.env.Environment;
import org.springframework.stereotype.Component;

/**
 * Free space on the disk that the server writes to. With less than {@code sitaf.min-free} the
 * server accepts no new work, so that running work can finish. With less than a quarter of that it
 * writes nothing, so that no write fails half-way.
 */
@Component
public class DiskSpace {
  private static final long MIB = 1 << 20;
  private static final int RESERVE_FRACTION = 4;

  private final Path data;
  private final boolean holdsDatabase;
  private final long minFree;
  private final ToLongFunction<Path> usableBytes;

  /**
   * Creates an instance that asks the file system.
   *
   * @throws DiskFullAtStartException if the disk is too full to start
   */
  @Autowired
  public DiskSpace(SitafSettings settings, Environment environment) {
    this(settings, GuardedDataSource.guards(environment), DiskSpace::usableBytes);
    whyNothingIsWritten()
        .ifPresent(
            why -> {
              throw new DiskFullAtStartException(why, settings);
            });
  }

  DiskSpace(SitafSettings settings, boolean holdsDatabase, ToLongFunction<Path> usableBytes) {
    this.holdsDatabase = holdsDatabase;
    this.data = settings.dataDirectory().toAbsolutePath();
    this.minFree = settings.minFree().toBytes();
    this.usableBytes = usableBytes;
  }

  /** Why the server accepts no new work; empty if it does. */
  public Optional<String> whyNoNewWork() {
    return shortage(minFree);
  }

  /** Why the server writes nothing; empty if there is enough space. */
  public Optional<String> whyNothingIsWritten() {
    return shortage(neededToWrite(minFree));
  }

  /** Below this many free bytes nothing is written. */
  static long neededToWrite(long minFree) {
    return minFree / RESERVE_FRACTION;
  }

  /** Whether the database is on this disk. */
  boolean holdsDatabase() {
    return holdsDatabase;
  }

  long freeBytes() {
    return usableBytes.applyAsLong(data);
  }

  /** Whether the server writes to the database. */
  public boolean canWrite() {
    return whyTheDatabaseIsNotWritten().isEmpty();
  }

  /**
   * Why the server does not write to the database; empty if it does, or if the database is on
   * another machine.
   */
  Optional<String> whyTheDatabaseIsNotWritten() {
    return holdsDatabase ? shortage(neededToWrite(minFree)) : Optional.empty();
  }

  /**
   * Checks that there is space for new work.
   *
   * @throws RequestException if the disk is too full
   */
  public void requireForNewWork() {
    whyNoNewWork()
        .ifPresent(
            why -> {
              throw RequestException.diskFull("The server accepts no new work", why);
            });
  }

  /**
   * Checks that there is space to store the given number of bytes.
   *
   * @throws RequestException if the disk is too full
   */
  public void requireFor(long bytes) {
    shortage(minFree == 0 ? 0 : neededToWrite(minFree) + bytes)
        .ifPresent(
            why -> {
              throw RequestException.diskFull("There is not enough disk space", why);
            });
  }

  private Optional<String> shortage(long needed) {
    if (needed == 0) {
      return Optional.empty();
    }
    long free = freeBytes();
    return free >= needed
        ? Optional.empty()
        : Optional.of(
            "the disk of the server's data has only %d MiB left, %d MiB are required"
                .formatted(free / MIB, (needed + MIB - 1) / MIB));
  }

  /** Usable space of the folder, or of its nearest parent that exists; 0 if there is none. */
  private static long usableBytes(Path folder) {
    for (Path path = folder; path != null; path = path.getParent()) {
      if (Files.exists(path)) {
        return path.toFile().getUsableSpace();
      }
    }
    return 0;
  }
}
