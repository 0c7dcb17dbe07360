package org.sitaf.agent.toolchain;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Folders and files of toolchains.
 *
 * @param runtimes holds {@code runtime-java}, {@code runtime-cpp} and {@code runtime-python}
 * @param cache private to the agent and kept between builds; created when needed
 * @param annotationProcessors jars of the annotation processors and compiler plugins that the
 *     administrator allows
 * @param earlier cache of commands on this machine, which is read only; null for none
 */
public record ToolchainPlaces(
    Path runtimes, Path cache, List<Path> annotationProcessors, @Nullable Path earlier) {
  public ToolchainPlaces {
    runtimes = runtimes.toAbsolutePath().normalize();
    cache = cache.toAbsolutePath().normalize();
    annotationProcessors =
        annotationProcessors.stream().map(jar -> jar.toAbsolutePath().normalize()).toList();
    earlier = earlier == null ? null : earlier.toAbsolutePath().normalize();
  }

  /** Without annotation processors. */
  public ToolchainPlaces(Path runtimes, Path cache) {
    this(runtimes, cache, List.of(), null);
  }

  /** A folder of the earlier cache. */
  public Optional<Path> earlier(String name) {
    return Optional.ofNullable(earlier).map(folder -> folder.resolve(name));
  }
}
