package org.sitaf.runtime.simulation;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * A folder with a recording of the motion in each case, as {@code NO.glb}: self-contained binary
 * glTF. When the folder is full, recordings are dropped until files have been removed from it.
 */
final class Recording {
  private static final long MAX_BYTES = 64L << 20;

  private final Path folder;
  private long bytes;

  /** Creates the folder. */
  Recording(Path folder) throws IOException {
    this.folder = Objects.requireNonNull(folder);
    Files.createDirectories(folder);
  }

  boolean isFull() {
    return bytes >= MAX_BYTES;
  }

  private long present() throws IOException {
    long sum = 0;
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
      for (Path file : files) {
        // The length is 0 if the file was removed in the meantime.
        sum += file.toFile().length();
      }
    }
    return sum;
  }

  void save(int no, byte[] motion) throws IOException {
    if (bytes + motion.length > MAX_BYTES) {
      bytes = present();
    }
    if (bytes + motion.length > MAX_BYTES) {
      bytes = MAX_BYTES;
      return;
    }
    bytes += motion.length;
    Files.write(folder.resolve(no + ".glb"), motion);
  }
}
