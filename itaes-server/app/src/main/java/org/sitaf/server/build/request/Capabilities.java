package org.sitaf.server.build.request;

import java.util.List;
import java.util.Set;

/**
 * What an agent offers.
 *
 * @param simulation whether worlds can be simulated there
 * @param labels what its owner calls it by, such as {@code real-hardware}
 */
public record Capabilities(List<Toolchain> toolchains, boolean simulation, Set<String> labels) {
  public Capabilities {
    toolchains = List.copyOf(toolchains);
    labels = Set.copyOf(labels);
  }

  /**
   * A language that an agent can compile and run.
   *
   * @param version such as {@code javac 17.0.15}
   */
  public record Toolchain(String language, String version) {
    /**
     * Whether a word of the version is the wanted one, or a release of it ({@code 17} and 17.0.15).
     */
    boolean isOf(String wanted) {
      return List.of(version.split("[\\s()]+")).stream()
          .anyMatch(word -> word.equals(wanted) || word.startsWith(wanted + "."));
    }
  }
}
