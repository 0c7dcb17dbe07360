package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** What Java test applications link against, and what watches them. */
final class RuntimeJars {
  private RuntimeJars() {}

  /**
   * The jars of a folder that holds the runtime of Java test applications, in the order of their
   * names.
   *
   * @throws IOException when it does not hold the runtime
   */
  static List<Path> in(Path directory) throws IOException {
    if (Files.isDirectory(directory)) {
      try (Stream<Path> files = Files.list(directory)) {
        List<Path> jars = files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
        if (jars.stream()
            .anyMatch(jar -> jar.getFileName().toString().startsWith("sitaf-runtime-java"))) {
          return jars;
        }
      }
    }
    throw new IOException(
        directory
            + " does not hold the runtime of Java test applications (sitaf-runtime-java-*.jar)");
  }

  /** The archive of classes that the installation has made of the jars. */
  static Optional<Path> archive(Path file) {
    return Files.isRegularFile(file) ? Optional.of(file) : Optional.empty();
  }

  /** The jar that records which lines are reached; empty where the folder has none. */
  static Optional<Path> recorder(Path directory) throws IOException {
    if (!Files.isDirectory(directory)) {
      return Optional.empty();
    }
    try (Stream<Path> files = Files.list(directory)) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().findFirst();
    }
  }
}
