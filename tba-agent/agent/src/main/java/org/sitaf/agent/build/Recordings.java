package org.sitaf.agent.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Takes what a test application recorded out of a folder that the component could write to. */
final class Recordings {
  private static final Pattern OF_A_CASE = Pattern.compile("[1-9][0-9]{0,8}\\.glb");
  private static final long MOST_BYTES = 64L << 20;

  private Recordings() {}

  /** Copies the files of cases, as far as they hold 64 MiB. */
  static void keep(Path from, Path to) throws IOException {
    if (!Files.isDirectory(from, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    Files.createDirectories(to);
    long bytes = 0;
    for (Path file : files(from)) {
      bytes += Files.size(file);
      if (bytes > MOST_BYTES) {
        return;
      }
      Files.copy(file, to.resolve(file.getFileName()), StandardCopyOption.REPLACE_EXISTING);
    }
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> OF_A_CASE.matcher(file.getFileName().toString()).matches())
          .filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS))
          .sorted()
          .toList();
    }
  }
}
