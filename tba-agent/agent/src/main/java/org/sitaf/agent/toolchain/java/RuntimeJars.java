package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The jars of the runtime of Java test applications. */
final class RuntimeJars {
  private RuntimeJars() {}

  /**
   * The jars of the runtime's folder, sorted by name.
   *
   * @throws IOException if the folder does not hold the runtime
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

  /** The class data sharing archive that the installation created. */
  static Optional<Path> archive(Path file) {
    return Files.isRegularFile(file) ? Optional.of(file) : Optional.empty();
  }

  /** The jar of the coverage recorder; empty if it is not installed. */
  static Optional<Path> recorder(Path directory) throws IOException {
    if (!Files.isDirectory(directory)) {
      return Optional.empty();
    }
    try (Stream<Path> files = Files.list(directory)) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().findFirst();
    }
  }

  /** The jar of the compiler process. */
  static Path compiler(Path directory) throws IOException {
    Path jar = directory.resolve("compiler-java.jar");
    if (!Files.isRegularFile(jar)) {
      throw new IOException(directory + " does not hold the jar of the Java compiler process");
    }
    return jar;
  }

  /** All jars in the folder of a jar. */
  static List<Path> jars(Path one) {
    try (Stream<Path> files = Files.list(one.getParent())) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Checks jars that an administrator configured. */
  static List<Path> required(List<Path> jars) throws IOException {
    for (Path jar : jars) {
      if (!Files.isRegularFile(jar)) {
        throw new IOException("--annotation-processor-path: there is no file " + jar);
      }
    }
    return jars;
  }
}
