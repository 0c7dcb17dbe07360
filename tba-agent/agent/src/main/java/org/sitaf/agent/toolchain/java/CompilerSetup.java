package org.sitaf.agent.toolchain.java;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * The command of the Java compiler's JVM, whose class path holds only the compiler's jar.
 *
 * @param program the compiler's jar
 * @param archive class data sharing archive for a faster start; null for none
 * @param runtime jars at the start of each class path
 * @param processors jars of annotation processors and compiler plugins that the administrator
 *     allows; all others are ignored, whatever a jar on the class path declares
 */
record CompilerSetup(
    Path program, @Nullable Path archive, List<Path> runtime, List<Path> processors) {
  /** Heap size of the compiler. */
  static final int MEMORY_MIB = 1024;

  static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));

  private static final String MAIN = "org.sitaf.agent.toolchain.java.confined.CompilerMain";
  private static final List<String> OPTIONS =
      List.of("--release", "17", "-g", "-nowarn", "-implicit:none");

  CompilerSetup {
    runtime = List.copyOf(runtime);
    processors = List.copyOf(processors);
  }

  /** JVM options for a fast start and limited memory. */
  static List<String> jvm(int memoryMiB, Path temporary) {
    return List.of(
        JAVA_HOME.resolve("bin").resolve("java").toString(),
        "-Xmx" + memoryMiB + "m",
        "-XX:+UseSerialGC",
        "-XX:TieredStopAtLevel=1",
        "-Xshare:auto",
        "-XX:-UsePerfData",
        "-XX:-CreateCoredumpOnCrash",
        "-XX:+ExitOnOutOfMemoryError",
        // Standard output is reserved for messages.
        "-XX:+DisplayVMOutputToStderr",
        "-XX:ErrorFile=" + temporary.resolve("hs_err.log"),
        "-Djava.io.tmpdir=" + temporary,
        "-Dfile.encoding=UTF-8");
  }

  List<String> command(Path temporary) {
    List<String> command = new ArrayList<>(jvm(MEMORY_MIB, temporary));
    if (archive != null) {
      command.add("-XX:SharedArchiveFile=" + archive);
      // The JVM silently ignores an archive of another Java version.
      command.add("-Xlog:cds=off");
      command.add("-Xlog:cds+dynamic=off");
    }
    command.addAll(List.of("-cp", program.toString(), MAIN, path(runtime), path(processors)));
    command.addAll(options());
    return command;
  }

  List<Path> readable() {
    List<Path> readable = new ArrayList<>(List.of(JAVA_HOME, program));
    readable.addAll(runtime);
    readable.addAll(processors);
    if (archive != null) {
      readable.add(archive);
    }
    return readable;
  }

  /** Everything except the sources that determines the result. */
  String identity() throws IOException {
    StringBuilder identity = new StringBuilder(options().toString());
    List<Path> jars = new ArrayList<>(runtime);
    jars.addAll(processors);
    jars.add(program);
    for (Path jar : jars) {
      // Size and time identify a jar; reading megabytes for each build would add nothing.
      identity.append('\n').append(jar).append(' ').append(Files.size(jar));
      identity.append(' ').append(Files.getLastModifiedTime(jar));
    }
    return identity.toString();
  }

  private List<String> options() {
    List<String> options = new ArrayList<>(OPTIONS);
    if (processors.isEmpty()) {
      options.add("-proc:none");
    }
    return options;
  }

  private static String path(List<Path> jars) {
    return jars.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
  }
}
