package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.util.List;

/**
 * Where toolchains find what is SITAF's.
 *
 * @param runtimes holds {@code runtime-java}, {@code runtime-cpp} and {@code runtime-python}
 * @param cache private to the agent, kept from build to build; created when it is needed
 * @param annotationProcessors jars of the annotation processors and plugins that Java's compiler
 *     may run; an administrator names them
 */
public record ToolchainPlaces(Path runtimes, Path cache, List<Path> annotationProcessors) {
  public ToolchainPlaces {
    runtimes = runtimes.toAbsolutePath().normalize();
    cache = cache.toAbsolutePath().normalize();
    annotationProcessors =
        annotationProcessors.stream().map(jar -> jar.toAbsolutePath().normalize()).toList();
  }

  /** Without annotation processors. */
  public ToolchainPlaces(Path runtimes, Path cache) {
    this(runtimes, cache, List.of());
  }
}
