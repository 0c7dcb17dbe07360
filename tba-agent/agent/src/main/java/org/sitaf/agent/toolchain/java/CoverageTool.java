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
 * JaCoCo. Classes and records are the component's, so that they are read in the sandbox.
 *
 * @param recorder JaCoCo's agent, a jar
 * @param reader jars of what reads its records
 */
record CoverageTool(Path recorder, List<Path> reader) {
  private static final String MAIN = "org.sitaf.agent.toolchain.java.confined.CoverageMain";
  private static final Duration LIMIT = Duration.ofMinutes(1);
  private static final long MOST_BYTES = 64L << 20;
  private static final int MEMORY_MIB = 512;
  private static final int OVERHEAD_MIB = 256;
  private static final ProcessLimits LIMITS =
      new ProcessLimits(MEMORY_MIB + OVERHEAD_MIB, 256, 64, LIMIT);

  CoverageTool {
    reader = List.copyOf(reader);
  }

  /** What processes have recorded under a name in their folders of {@code data}, line by line. */
  List<String> read(Path classes, Path data, String name, Path scratch, Sandbox sandbox)
      throws IOException, InterruptedException {
    Path work = Files.createTempDirectory(Files.createDirectories(scratch), "coverage");
    // Another user's process reads them than the one that left them.
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
            LIMIT);
    if (end.code() != 0) {
      throw new IOException(
          "JaCoCo's reader "
              + (end.timedOut() ? "was given up after " + LIMIT.toSeconds() + " s" : "failed: ")
              + end.errors().lines().findFirst().orElse(""));
    }
    return end.output().lines().toList();
  }

  /** Copies a record, if it is one: its process has ended, so that it stays what it is. */
  private static void copy(Path record, Path copy) throws IOException {
    if (!Files.isRegularFile(record, LinkOption.NOFOLLOW_LINKS)
        || Files.size(record) > MOST_BYTES) {
      return;
    }
    try (InputStream content = Files.newInputStream(record, LinkOption.NOFOLLOW_LINKS)) {
      Files.copy(content, copy);
    }
  }
}
