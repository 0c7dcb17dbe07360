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
 * Line coverage of a Python component, measured by coverage.py.
 *
 * @param python interpreter of an environment with coverage.py
 * @param readable paths that the interpreter reads
 * @param copy folder from which the component's sources run
 * @param sources the corresponding folder in the activity, with a trailing slash
 * @param scratch absolute folder for temporary files
 */
record PythonCoverage(
    Path python, List<Path> readable, Path copy, String sources, Path scratch, Sandbox sandbox)
    implements Recording {
  private static final String DATA = "python.coverage";
  private static final Duration TIMEOUT = Duration.ofMinutes(1);
  private static final int MAX_FILES = 2000;
  private static final int MAX_BYTES = 32 << 20;

  PythonCoverage {
    readable = List.copyOf(readable);
  }

  @Override
  public List<String> recorder(Path directory) {
    return List.of(
        // When a module cannot be imported, that is the last line of the error stream, and the
        // message of the build.
        "-W",
        "ignore:No data was collected",
        "-m",
        "coverage",
        "run",
        "--branch",
        "--data-file=" + directory.resolve(DATA),
        "--source=" + copy);
  }

  /**
   * Reads the recorded data. coverage.py runs in the sandbox, because its input comes from
   * untrusted processes.
   */
  @Override
  public Coverage read(Path data) throws IOException, InterruptedException {
    List<Path> recorded = LeftFiles.in(data, file -> file.endsWith(DATA), MAX_FILES);
    Path work = Files.createTempDirectory(Files.createDirectories(scratch), "coverage");
    List<String> combine = new ArrayList<>(List.of("combine", "--keep", "--quiet"));
    combine.add("--data-file=all");
    for (Path file : recorded) {
      // A killed process may leave an incomplete record, which coverage.py skips.
      Path own = work.resolve("process" + combine.size());
      Files.write(own, LeftFiles.read(file, MAX_BYTES));
      combine.add(own.getFileName().toString());
    }
    run(work, combine);
    run(work, List.of("lcov", "--quiet", "--data-file=all", "-o", "report"));
    String root = copy.getFileName() + "/";
    Coverage coverage =
        LcovReport.read(
            new String(LeftFiles.read(work.resolve("report"), MAX_BYTES), StandardCharsets.UTF_8),
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
            TIMEOUT);
    if (end.code() != 0) {
      throw new IOException(
          "coverage "
              + arguments.get(0)
              + ": "
              + (end.output() + end.errors()).lines().findFirst().orElse("no output"));
    }
  }
}
