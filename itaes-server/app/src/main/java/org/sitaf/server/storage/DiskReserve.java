package org.sitaf.server.storage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.function.LongSupplier;
import org.sitaf.server.settings.SitafSettings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.stereotype.Component;

/**
 * Space that is kept for the end of transactions on a full disk. H2 also writes a few pages when a
 * transaction is rolled back, or when one that has only read is committed, and closes the database
 * for all readers if it cannot. The space is kept in several files, since another program can use
 * the space of a removed one first.
 */
@Component
class DiskReserve {
  private static final Logger log = LoggerFactory.getLogger(DiskReserve.class);
  private static final int PIECES = 4;
  private static final long MAX_PIECE = 4L << 20;

  /** The whole reserve is an eighth of {@code sitaf.min-free} at most. */
  private static final int PIECE_FRACTION = 8 * PIECES;

  private final Path folder;
  private final long piece;
  private final LongSupplier freeBytes;
  private final long writable;

  /** Keeps nothing if the database is not in a local file, or if the check of space is disabled. */
  @Autowired
  DiskReserve(SitafSettings settings, DiskSpace disk) {
    this(
        settings.dataDirectory().toAbsolutePath().resolve("reserve"),
        disk.holdsDatabase() ? settings.minFree().toBytes() : 0,
        disk::freeBytes);
  }

  DiskReserve(Path folder, long minFree, LongSupplier freeBytes) {
    this.folder = folder;
    this.piece = Math.min(MAX_PIECE, minFree / PIECE_FRACTION);
    this.writable = DiskSpace.neededToWrite(minFree);
    this.freeBytes = freeBytes;
  }

  /** Takes what is missing of the reserve, unless that would stop the server from writing. */
  synchronized void refill() {
    if (piece == 0) {
      return;
    }
    for (int number = 0; number < PIECES; number++) {
      Path file = file(number);
      if (!Files.exists(file) && freeBytes.getAsLong() >= writable + piece) {
        take(file);
      }
    }
  }

  /** Gives back a part of the reserve if too little is free to end a transaction. */
  void giveBackIfNeeded() {
    if (piece > 0 && freeBytes.getAsLong() < piece / 2) {
      giveBack();
    }
  }

  private synchronized void giveBack() {
    for (int number = 0; number < PIECES && freeBytes.getAsLong() < piece / 2; number++) {
      try {
        if (Files.deleteIfExists(file(number))) {
          log.warn("Disk full, {} KiB of the reserve in {} are used", piece >> 10, folder);
        }
      } catch (IOException e) {
        log.warn("Part {} of the reserve in {} cannot be removed", number, folder, e);
      }
    }
  }

  private void take(Path file) {
    // A file system can store zeros without using space.
    byte[] content = new byte[Math.toIntExact(piece)];
    new Random(0).nextBytes(content);
    try {
      Files.createDirectories(folder);
      Files.write(file, content);
    } catch (IOException e) {
      log.debug("Part of the reserve could not be stored", e);
      delete(file);
    }
  }

  private static void delete(Path file) {
    try {
      Files.deleteIfExists(file);
    } catch (IOException e) {
      log.warn("An incomplete part of the reserve cannot be removed: {}", file, e);
    }
  }

  private Path file(int number) {
    return folder.resolve(Integer.toString(number));
  }
}
