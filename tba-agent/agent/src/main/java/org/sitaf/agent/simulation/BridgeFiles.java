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

/** Which files a bridge reads: its Python's, and those of the packages that it is made of. */
final class BridgeFiles {
  private static final long PROBE_S = 20;
  private static final String MODULE = "-m";

  private static final String PROBE =
      "import sys, os, sitaf_bridge; print(*{os.path.abspath(p) for p in [sys.prefix,"
          + " sys.base_prefix, os.path.dirname(os.path.dirname(sitaf_bridge.__file__)),"
          + " *filter(None, sys.path)] if os.path.exists(p)}, sep='\\n"
          + "')";

  /** By command; what is installed does not move while an agent runs. */
  private static final Map<List<String>, List<Path>> KNOWN = new ConcurrentHashMap<>();

  private BridgeFiles() {}

  /**
   * Folders and files, absolute, for the sandbox to show.
   *
   * @throws IOException when the command's program cannot be started
   */
  static List<Path> of(List<String> command, Sandbox sandbox)
      throws IOException, InterruptedException {
    if (sandbox.kind().equals(Sandbox.NONE)) {
      return List.of();
    }
    List<Path> known = KNOWN.get(command);
    if (known == null) {
      known = command.contains(MODULE) ? ofPython(command) : named(command);
      KNOWN.put(List.copyOf(command), known);
    }
    return known;
  }

  private static List<Path> ofPython(List<String> command)
      throws IOException, InterruptedException {
    List<String> probe = new ArrayList<>(command.subList(0, command.indexOf(MODULE)));
    probe.addAll(List.of("-c", PROBE));
    // From a folder without modules: the current one would be searched first.
    Process process =
        new ProcessBuilder(probe)
            .directory(Path.of("/").toFile())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      process.getOutputStream().close();
      String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      if (!process.waitFor(PROBE_S, TimeUnit.SECONDS) || process.exitValue() != 0) {
        // What is wrong the bridge itself says when it starts.
        return named(command);
      }
      List<Path> folders =
          said.lines()
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

  /** Files that the command's words name. */
  private static List<Path> named(List<String> command) {
    return command.stream()
        .filter(word -> word.startsWith("/"))
        .map(Path::of)
        .filter(Files::isRegularFile)
        .toList();
  }
}
