package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.util.List;

/**
 * Folders and files of toolchains.
 *
 * @param runtimes holds {@code runtime-java}, {@code runtime-cpp} and {@code runtime-python}
 * @param cache private to the agent and kept between builds; created when needed
 * @param annotationProcessors jars of the annotation processors and compiler plugins that the
 *     administrator allows
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
