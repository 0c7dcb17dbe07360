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
 * How Java's compiler is started: a JVM that holds nothing of the agent but the compiler's jar.
 *
 * @param program the compiler's jar
 * @param archive of the classes that it loads, for a faster start; null where there is none
 * @param runtime jars that each class path begins with
 * @param processors jars of annotation processors and plugins that an administrator has named;
 *     without them none run, whatever a jar of the class path asks for
 */
record CompilerSetup(
    Path program, @Nullable Path archive, List<Path> runtime, List<Path> processors) {
  /** What the compiler's heap may hold. */
  static final int MEMORY_MIB = 1024;

  static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));

  private static final String MAIN = "org.sitaf.agent.toolchain.java.confined.CompilerMain";
  private static final List<String> OPTIONS =
      List.of("--release", "17", "-g", "-nowarn", "-implicit:none");

  CompilerSetup {
    runtime = List.copyOf(runtime);
    processors = List.copyOf(processors);
  }

  /** A JVM that starts fast and keeps to its memory. */
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
        // Standard output carries messages alone.
        "-XX:+DisplayVMOutputToStderr",
        "-XX:ErrorFile=" + temporary.resolve("hs_err.log"),
        "-Djava.io.tmpdir=" + temporary,
        "-Dfile.encoding=UTF-8");
  }

  List<String> command(Path temporary) {
    List<String> command = new ArrayList<>(jvm(MEMORY_MIB, temporary));
    if (archive != null) {
      command.add("-XX:SharedArchiveFile=" + archive);
      // An archive of another Java is left out without a word.
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

  /** All that decides, next to the sources, what is compiled. */
  String identity() throws IOException {
    StringBuilder identity = new StringBuilder(options().toString());
    List<Path> jars = new ArrayList<>(runtime);
    jars.addAll(processors);
    jars.add(program);
    for (Path jar : jars) {
      // Jars are replaced as a whole; reading megabytes for each build would tell no more.
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
