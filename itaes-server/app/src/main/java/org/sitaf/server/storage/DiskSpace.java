package org.sitaf.server.storage;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.ToLongFunction;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.core.env.Environment;
import org.springframework.stereotype.Component;

/**
 * Room on the disk that the server writes to. With less than {@code sitaf.min-free} it takes no new
 * work, so that what it has taken can come to its end; with less than the reserve, a quarter of
 * that, it writes nothing at all, so that no write fails half-way.
 */
@Component
public class DiskSpace {
  private static final long MIB = 1 << 20;
  private static final int RESERVES = 4;

  private final Path data;
  private final boolean holdsDatabase;
  private final long minFree;
  private final ToLongFunction<Path> usableBytes;

  /**
   * Asks the file system.
   *
   * @throws NoRoomToStartException when there is no room for the little that every start writes
   */
  @Autowired
  public DiskSpace(SitafSettings settings, Environment environment) {
    this(settings, GuardedDataSource.guards(environment), DiskSpace::usableBytes);
    whyNothingIsWritten()
        .ifPresent(
            why -> {
              throw new NoRoomToStartException(why, settings);
            });
  }

  DiskSpace(SitafSettings settings, boolean holdsDatabase, ToLongFunction<Path> usableBytes) {
    this.holdsDatabase = holdsDatabase;
    this.data = settings.dataDirectory().toAbsolutePath();
    this.minFree = settings.minFree().toBytes();
    this.usableBytes = usableBytes;
  }

  /** Why no new work is taken; empty when it is. */
  public Optional<String> whyNoNewWork() {
    return lack(minFree);
  }

  /** Why nothing is written any more; empty when there is room. */
  public Optional<String> whyNothingIsWritten() {
    return lack(minFree / RESERVES);
  }

  /** Whether the database is written to at present. */
  public boolean canWrite() {
    return whyTheDatabaseIsNotWritten().isEmpty();
  }

  /** Why the database is not written to; empty when it is, and where its disk is not ours. */
  Optional<String> whyTheDatabaseIsNotWritten() {
    return holdsDatabase ? lack(minFree / RESERVES) : Optional.empty();
  }

  /**
   * Makes sure that there is room for new work.
   *
   * @throws Refusal when there is none
   */
  public void requireForNewWork() {
    whyNoNewWork()
        .ifPresent(
            why -> {
              throw Refusal.noRoom("No new work is taken", why);
            });
  }

  /**
   * Makes sure that there is room to keep something large.
   *
   * @throws Refusal when there is none
   */
  public void requireFor(long bytes) {
    lack(minFree == 0 ? 0 : minFree / RESERVES + bytes)
        .ifPresent(
            why -> {
              throw Refusal.noRoom("There is no room for it", why);
            });
  }

  private Optional<String> lack(long needed) {
    if (needed == 0) {
      return Optional.empty();
    }
    long free = usableBytes.applyAsLong(data);
    return free >= needed
        ? Optional.empty()
        : Optional.of(
            "the disk of the server's data has only %d MiB left, %d are needed"
                .formatted(free / MIB, (needed + MIB - 1) / MIB));
  }

  /** Of the folder, or of where it will be made; 0 where nobody knows. */
  private static long usableBytes(Path folder) {
    for (Path place = folder; place != null; place = place.getParent()) {
      if (Files.exists(place)) {
        return place.toFile().getUsableSpace();
      }
    }
    return 0;
  }
}
