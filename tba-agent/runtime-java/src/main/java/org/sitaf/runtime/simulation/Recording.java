package org.sitaf.runtime.simulation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * A folder with what moved in each case, as {@code NO.glb}: binary glTF, complete in itself. A full
 * folder takes no more.
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

  void save(int no, byte[] motion) throws IOException {
    if (bytes + motion.length > MOST_BYTES) {
      bytes = MOST_BYTES;
      return;
    }
    bytes += motion.length;
    Files.write(folder.resolve(no + ".glb"), motion);
  }
}
