package org.sitaf.agent.toolchain.java;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;

/**
 * JaCoCo. Runs in the sandbox, because it reads classes and records of the component.
 *
 * @param recorder the jar of JaCoCo's agent
 * @param reader jars that read the records
 */
record CoverageTool(Path recorder, List<Path> reader) {
  private static final String MAIN = "org.sitaf.agent.toolchain.java.confined.CoverageMain";
  private static final Duration TIMEOUT = Duration.ofMinutes(1);
  private static final long MAX_BYTES = 64L << 20;
  private static final int MEMORY_MIB = 512;
  private static final int OVERHEAD_MIB = 256;
  private static final ProcessLimits LIMITS =
      new ProcessLimits(MEMORY_MIB + OVERHEAD_MIB, 256, 64, TIMEOUT);

  CoverageTool {
    reader = List.copyOf(reader);
  }

  /** Reads the records of all processes, one folder each, and returns the counts per line. */
  List<String> read(Path classes, Path data, String name, Path scratch, Sandbox sandbox)
      throws IOException, InterruptedException {
    Path work = Files.createTempDirectory(Files.createDirectories(scratch), "coverage");
    // The reader runs as another sandbox user than the processes that wrote the records.
    Path records = Files.createDirectories(work.resolve("records"));
    try (DirectoryStream<Path> processes = Files.newDirectoryStream(data)) {
      int count = 0;
      for (Path process : processes) {
        copy(process.resolve(name), records.resolve("process" + ++count));
      }
    }
    List<String> command = new ArrayList<>(CompilerSetup.jvm(MEMORY_MIB, work));
    command.addAll(
        List.of(
            "-cp",
            reader.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator)),
            MAIN,
            classes.toString(),
            records.toString()));
    ToolResult end =
        sandbox.run(
            Confinement.of(command, work, work, LIMITS)
                .reading(List.of(CompilerSetup.JAVA_HOME, classes))
                .reading(reader),
            TIMEOUT);
    if (end.code() != 0) {
      throw new IOException(
          "JaCoCo's reader "
              + (end.timedOut()
                  ? "did not finish within " + TIMEOUT.toSeconds() + " s"
                  : "failed: ")
              + end.errors().lines().findFirst().orElse(""));
    }
    return end.output().lines().toList();
  }

  /** Copies a record if it is valid; its process has ended, so it no longer changes. */
  private static void copy(Path record, Path copy) throws IOException {
    if (!Files.isRegularFile(record, LinkOption.NOFOLLOW_LINKS) || Files.size(record) > MAX_BYTES) {
      return;
    }
    try (InputStream content = Files.newInputStream(record, LinkOption.NOFOLLOW_LINKS)) {
      Files.copy(content, copy);
    }
  }
}
