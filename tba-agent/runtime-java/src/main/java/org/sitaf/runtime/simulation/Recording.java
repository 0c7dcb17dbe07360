package org.sitaf.runtime.simulation;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * A folder with what moved in each case, as {@code NO.glb}: binary glTF, complete in itself. A full
 * folder takes no more; files that were taken out of it meanwhile make room.
 */
final class Recording {
  private static final long MOST_BYTES = 64L << 20;

  private final Path folder;
  private long bytes;

  /** A recording into a folder, which is made. */
  Recording(Path folder) throws IOException {
    this.folder = Objects.requireNonNull(folder);
    Files.createDirectories(folder);
  }

  boolean isFull() {
    return bytes >= MOST_BYTES;
  }

  private long present() throws IOException {
    long sum = 0;
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
      for (Path file : files) {
        // 0 of one that is taken at this moment.
        sum += file.toFile().length();
      }
    }
    return sum;
  }

  void save(int no, byte[] motion) throws IOException {
    if (bytes + motion.length > MOST_BYTES) {
      bytes = present();
    }
    if (bytes + motion.length > MOST_BYTES) {
      bytes = MOST_BYTES;
      return;
    }
    bytes += motion.length;
    Files.write(folder.resolve(no + ".glb"), motion);
  }
}
