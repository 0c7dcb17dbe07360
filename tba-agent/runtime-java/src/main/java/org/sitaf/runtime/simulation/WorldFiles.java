package org.sitaf.runtime.simulation;

import com.google.protobuf.ByteString;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.sim.v1.WorldSource;

/**
 * Reads a world description and all files of its folder into a request, so that the simulator never
 * opens files of its host.
 */
final class WorldFiles {
  private static final long MAX_BYTES = 64L << 20;

  private WorldFiles() {}

  /**
   * Reads the folder of a world description. Symbolic links are ignored.
   *
   * @throws IOException when a file cannot be read, or the folder exceeds the limits of a world
   */
  static WorldSource read(Path description) throws IOException {
    Path file = description.toAbsolutePath().normalize();
    Path folder = file.getParent();
    if (folder == null || !Files.isRegularFile(file)) {
      throw new IOException(description + " is not a file");
    }
    WorldSource.Builder world =
        WorldSource.newBuilder().setDescription(file.getFileName().toString());
    long total = 0;
    for (Path path : filesBelow(folder)) {
      total += Files.size(path);
      if (total > MAX_BYTES) {
        throw new IOException("the files of the world are larger than " + MAX_BYTES + " bytes");
      }
      String name = folder.relativize(path).toString().replace('\\', '/');
      world.putFiles(name, ByteString.copyFrom(Files.readAllBytes(path)));
    }
    return world.build();
  }

  private static List<Path> filesBelow(Path folder) throws IOException {
    try (Stream<Path> paths = Files.walk(folder)) {
      return paths.filter(p -> Files.isRegularFile(p, LinkOption.NOFOLLOW_LINKS)).sorted().toList();
    }
  }
}
