package org.sitaf.agent.toolchain.cpp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Questions to pkg-config about the libraries of this machine. */
final class PkgConfig {
  static final String PROGRAM = "pkg-config";

  private PkgConfig() {}

  /** Whether a library and all that it requires are installed. */
  static boolean exists(String library) {
    return Tools.outputOf(List.of(PROGRAM, "--exists", library)).isPresent();
  }

  /**
   * The version of a library; empty if it is not installed.
   *
   * <p>Does not ask for the libraries that it requires: pkgconf reads their whole graph otherwise,
   * which takes it most of a second for gRPC. The original pkg-config does not have this option.
   */
  static Optional<String> version(String library) {
    return Tools.outputOf(List.of(PROGRAM, "--maximum-traverse-depth=1", "--modversion", library))
        .or(() -> Tools.outputOf(List.of(PROGRAM, "--modversion", library)));
  }

  /**
   * Options of the compiler or linker; empty if one of the libraries is not installed.
   *
   * @param which such as {@code --cflags}
   */
  static Optional<List<String>> flags(String which, List<String> libraries) {
    List<String> question = new ArrayList<>(List.of(PROGRAM, which));
    question.addAll(libraries);
    return Tools.outputOf(question)
        .map(
            answer -> Arrays.stream(answer.split("\\s+")).filter(word -> !word.isEmpty()).toList());
  }
}
