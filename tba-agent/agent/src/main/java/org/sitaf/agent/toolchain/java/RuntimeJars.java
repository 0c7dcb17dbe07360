package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.io.UncheckedIOException;
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
   * @throws IOException if it does not hold the runtime
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

  /** The jar of the compiler's process. */
  static Path compiler(Path directory) throws IOException {
    Path jar = directory.resolve("compiler-java.jar");
    if (!Files.isRegularFile(jar)) {
      throw new IOException(directory + " does not hold the process of the Java compiler");
    }
    return jar;
  }

  /** All jars of the folder that a jar is in. */
  static List<Path> jars(Path one) {
    try (Stream<Path> files = Files.list(one.getParent())) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Jars that an administrator has named. */
  static List<Path> required(List<Path> jars) throws IOException {
    for (Path jar : jars) {
      if (!Files.isRegularFile(jar)) {
        throw new IOException("--annotation-processor-path: there is no file " + jar);
      }
    }
    return jars;
  }
}
