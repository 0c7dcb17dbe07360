package org.sitaf.server.build.request;

import java.util.List;
import java.util.Set;

/**
 * What an agent provides.
 *
 * @param simulation whether it can run simulations
 * @param analyses whether it accepts analyses of builds
 * @param labels set by its operator, such as {@code real-hardware}
 * @param devices names of the real devices that its builds may use
 */
public record Capabilities(
    List<Toolchain> toolchains,
    boolean simulation,
    boolean analyses,
    Set<String> labels,
    Set<String> devices) {
  public Capabilities {
    toolchains = List.copyOf(toolchains);
    labels = Set.copyOf(labels);
    devices = Set.copyOf(devices);
  }

  /**
   * The toolchain of a language.
   *
   * @param version such as {@code javac 17.0.15}
   */
  public record Toolchain(String language, String version) {
    /**
     * Whether the version contains the required one or a release of it: 17.0.15 matches {@code 17}.
     */
    boolean matches(String required) {
      return List.of(version.split("[\\s()]+")).stream()
          .anyMatch(word -> word.equals(required) || word.startsWith(required + "."));
    }
  }
}
