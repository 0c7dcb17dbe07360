package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.LeftFiles;
import org.sitaf.agent.toolchain.coverage.LcovReport;
import org.sitaf.core.verdict.Coverage;

/**
 * Which lines of a Python component are reached, by coverage.py.
 *
 * @param python interpreter of an environment that holds coverage.py
 * @param readable what that interpreter needs
 * @param copy folder of the component's sources as they run
 * @param sources what that folder is within the activity, with a slash at its end
 * @param scratch a folder for what nobody needs afterwards, absolute
 */
record PythonCoverage(
    Path python, List<Path> readable, Path copy, String sources, Path scratch, Sandbox sandbox) {
  private static final String DATA = "python.coverage";
  private static final Duration LIMIT = Duration.ofMinutes(1);
  private static final int MOST_FILES = 2000;
  private static final int MOST_BYTES = 32 << 20;

  PythonCoverage {
    readable = List.copyOf(readable);
  }

  /** What a process is started with, before its module, to record into a folder. */
  List<String> recorder(Path directory) {
    return List.of(
        "-m",
        "coverage",
        "run",
        "--branch",
        "--data-file=" + directory.resolve(DATA),
        "--source=" + copy);
  }

  /**
   * Reads what processes have recorded; coverage.py, whose input they made, runs in the sandbox.
   *
   * @param data holds a folder a process
   */
  Coverage read(Path data) throws IOException, InterruptedException {
    List<Path> recorded = LeftFiles.in(data, file -> file.endsWith(DATA), MOST_FILES);
    Path work = Files.createTempDirectory(Files.createDirectories(scratch), "coverage");
    List<String> combine = new ArrayList<>(List.of("combine", "--keep", "--quiet"));
    combine.add("--data-file=all");
    for (Path file : recorded) {
      // A process that was killed may leave half a record behind; coverage.py passes over it.
      Path own = work.resolve("process" + combine.size());
      Files.write(own, LeftFiles.read(file, MOST_BYTES));
      combine.add(own.getFileName().toString());
    }
    run(work, combine);
    run(work, List.of("lcov", "--quiet", "--data-file=all", "-o", "report"));
    String root = copy.getFileName() + "/";
    Coverage coverage =
        LcovReport.read(
            new String(LeftFiles.read(work.resolve("report"), MOST_BYTES), StandardCharsets.UTF_8),
            copy.getParent().toString(),
            root);
    return new Coverage(
        coverage.files().stream()
            .map(
                file ->
                    new Coverage.File(sources + file.path().substring(root.length()), file.lines()))
            .toList());
  }

  private void run(Path work, List<String> arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(python.toString(), "-I", "-m", "coverage"));
    command.addAll(arguments);
    ToolResult end =
        sandbox.run(
            Confinement.of(command, work, work, ProcessLimits.TOOL)
                .withEnvironment(Map.of("PYTHONUTF8", "1"))
                .reading(readable)
                .reading(List.of(copy)),
            LIMIT);
    if (end.code() != 0) {
      throw new IOException(
          "coverage "
              + arguments.get(0)
              + ": "
              + (end.output() + end.errors()).lines().findFirst().orElse("no answer"));
    }
  }
}
