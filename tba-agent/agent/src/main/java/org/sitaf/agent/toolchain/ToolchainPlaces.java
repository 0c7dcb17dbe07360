package org.sitaf.agent.toolchain;

import java.nio.file.Path;

/**
 * Where toolchains find what is SITAF's.
 *
 * @param runtimes holds {@code runtime-java}, {@code runtime-cpp} and {@code runtime-python}
 * @param cache private to the agent, kept from build to build; created when it is needed
 */
public record ToolchainPlaces(Path runtimes, Path cache) {
  public ToolchainPlaces {
    runtimes = runtimes.toAbsolutePath().normalize();
    cache = cache.toAbsolutePath().normalize();
  }
}
