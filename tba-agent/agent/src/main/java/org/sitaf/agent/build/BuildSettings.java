package org.sitaf.agent.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.Toolchains;

/**
 * What builds need of the machine that runs them.
 *
 * @param runtimeJars what Java test applications link against, absolute
 * @param simulator shared by the builds; the caller closes it
 * @param agent name and version of the agent for the provenance; empty for a local run
 */
public record BuildSettings(
    List<Path> runtimeJars, Simulator simulator, Toolchains toolchains, String agent) {
  public BuildSettings {
    runtimeJars = runtimeJars.stream().map(Path::toAbsolutePath).toList();
    Objects.requireNonNull(simulator);
    Objects.requireNonNull(toolchains);
    Objects.requireNonNull(agent);
  }

  /**
   * The jars of a folder that holds the runtime of Java test applications, in the order of their
   * names.
   *
   * @throws IOException when it does not hold the runtime
   */
  public static List<Path> runtimeJarsIn(Path directory) throws IOException {
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
}
