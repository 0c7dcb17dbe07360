package org.sitaf.agent.toolchain.cpp;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The compiler of this machine.
 *
 * @param version such as {@code g++ 12.2.0}
 */
record Compiler(Path program, String version) {
  /**
   * How everything is compiled: with names and lines for what a crash says, without what a
   * component's warnings would drown.
   */
  static final List<String> OPTIONS =
      List.of("-std=c++17", "-O1", "-g1", "-fPIC", "-pthread", "-w");

  /** Diagnostics in one line each, without colours. */
  List<String> plainDiagnostics() {
    return List.of(
        "-fdiagnostics-color=never",
        isClang() ? "-fno-caret-diagnostics" : "-fno-diagnostics-show-caret");
  }

  /**
   * Whether what it notes of coverage is what gcov reads: clang's has the form of an older gcov.
   */
  boolean isMeasuredByGcov() {
    return !isClang();
  }

  private boolean isClang() {
    return version.startsWith("clang");
  }

  /** The compiler that is named, or else the first of this machine; empty where there is none. */
  static Optional<Path> find(@Nullable String named) {
    return named == null || named.isBlank()
        ? Tools.find("g++", "clang++")
        : Tools.find(named.strip());
  }

  static Compiler of(Path program) {
    String name = program.getFileName().toString();
    String number =
        Tools.ask(List.of(program.toString(), "-dumpfullversion", "-dumpversion"))
            .or(() -> Tools.ask(List.of(program.toString(), "-dumpversion")))
            .orElse("of unknown version");
    return new Compiler(program, name + " " + number);
  }
}
