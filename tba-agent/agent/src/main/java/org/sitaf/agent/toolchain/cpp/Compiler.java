package org.sitaf.agent.toolchain.cpp;

import java.nio.file.Path;
import java.util.List;

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
        version.startsWith("clang") ? "-fno-caret-diagnostics" : "-fno-diagnostics-show-caret");
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
