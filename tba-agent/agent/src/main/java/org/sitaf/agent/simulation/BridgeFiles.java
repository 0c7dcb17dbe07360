package org.sitaf.agent.simulation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.sitaf.agent.sandbox.Sandbox;

/** The files that a bridge reads: the Python installation and the installed packages. */
final class BridgeFiles {
  private static final long PROBE_S = 20;
  private static final String MODULE = "-m";

  private static final String PROBE =
      "import sys, os, sitaf_bridge; print(*{os.path.abspath(p) for p in [sys.prefix,"
          + " sys.base_prefix, os.path.dirname(os.path.dirname(sitaf_bridge.__file__)),"
          + " *filter(None, sys.path)] if os.path.exists(p)}, sep='\\n"
          + "')";

  /** By command; an installation does not move while the agent runs. */
  private static final Map<List<String>, List<Path>> KNOWN = new ConcurrentHashMap<>();

  private BridgeFiles() {}

  /**
   * Absolute paths that the sandbox must make readable.
   *
   * @throws IOException if the program cannot be started
   */
  static List<Path> of(List<String> command, Sandbox sandbox)
      throws IOException, InterruptedException {
    if (sandbox.kind().equals(Sandbox.NONE)) {
      return List.of();
    }
    List<Path> known = KNOWN.get(command);
    if (known == null) {
      known = command.contains(MODULE) ? ofPython(command) : pathsOf(command);
      KNOWN.put(List.copyOf(command), known);
    }
    return known;
  }

  private static List<Path> ofPython(List<String> command)
      throws IOException, InterruptedException {
    List<String> probe = new ArrayList<>(command.subList(0, command.indexOf(MODULE)));
    probe.addAll(List.of("-c", PROBE));
    // Run in a folder without modules, because Python searches the current folder first.
    Process process =
        new ProcessBuilder(probe)
            .directory(Path.of("/").toFile())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      process.getOutputStream().close();
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      if (!process.waitFor(PROBE_S, TimeUnit.SECONDS) || process.exitValue() != 0) {
        // The bridge will fail in the same way and report the reason.
        return pathsOf(command);
      }
      List<Path> folders =
          output
              .lines()
              .map(Path::of)
              .filter(path -> path.isAbsolute() && path.getNameCount() > 1)
              .distinct()
              .toList();
      return folders.stream()
          .filter(path -> folders.stream().noneMatch(o -> !o.equals(path) && path.startsWith(o)))
          .toList();
    } finally {
      process.destroyForcibly();
    }
  }

  /** The arguments that are paths of files. */
  private static List<Path> pathsOf(List<String> command) {
    return command.stream()
        .filter(word -> word.startsWith("/"))
        .map(Path::of)
        .filter(Files::isRegularFile)
        .toList();
  }
}
