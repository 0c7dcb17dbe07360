package org.sitaf.agent.toolchain.java;

import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;

/** A JVM with a TCP port for debuggers, which waits before it loads the test application. */
record JavaDebuggee(DebugPlace place, List<Path> classPath) implements Debuggee {
  private static final Path TOOLS = CompilerSetup.JAVA_HOME.resolve("bin");

  /**
   * The kernel's tables of TCP sockets; a look that is no connection, of which the JVM accepts one.
   */
  private static final List<Path> SOCKETS =
      List.of(Path.of("/proc/net/tcp"), Path.of("/proc/net/tcp6"));

  private static final String LISTENS = "0A";

  /** Main class of the runtime that waits for jdb. */
  private static final String START = "org.sitaf.runtime.DebugStart";

  /** The kernel lets a waiting process open the other end of the pipe within this time. */
  private static final Duration PAUSE = Duration.ofMillis(200);

  /**
   * The option that opens the port. An IDE resumes a JVM that is suspended at its start when the
   * breakpoints are set. The startup file of jdb cannot: it may be read before the JVM reports that
   * it is suspended.
   */
  static String option(DebugPlace place) {
    return "-agentlib:jdwp=transport=dt_socket,server=y,quiet=y,suspend="
        + (place.order().inTerminal() ? "n" : "y")
        + ",address=127.0.0.1:"
        + place.port();
  }

  /** What precedes the main class in the command, so that the JVM waits. */
  static List<String> start(DebugPlace place) {
    return place.order().inTerminal() ? List.of(START, place.pipe().toString()) : List.of();
  }

  /** What is missing on this machine. */
  static Optional<String> missingTool() {
    for (String tool : List.of("jdb", "javap")) {
      if (!Files.isExecutable(TOOLS.resolve(tool))) {
        return Optional.of(
            TOOLS.resolve(tool)
                + " does not exist; install a JDK with: apt-get install openjdk-17-jdk-headless");
      }
    }
    return Optional.empty();
  }

  @Override
  public boolean isReady() {
    String port = String.format(Locale.ROOT, ":%04X", place.port());
    for (Path table : SOCKETS) {
      try {
        for (String line : Files.readAllLines(table, StandardCharsets.US_ASCII)) {
          String[] words = line.strip().split("\\s+");
          if (words.length > 3 && words[1].endsWith(port) && words[3].equals(LISTENS)) {
            return true;
          }
        }
      } catch (IOException e) {
        // A kernel without IPv6 has no second table.
      }
    }
    return false;
  }

  @Override
  public List<String> debugger() throws IOException, InterruptedException {
    List<String> startup = new ArrayList<>();
    for (String method : MethodSignatures.of(place.order(), classPath)) {
      startup.add("stop in " + method);
    }
    // The process waits until the pipe is read, so the breakpoints are set.
    startup.add("read " + DebugPlace.PIPE);
    Files.write(place.folder().resolve(".jdbrc"), startup);
    return List.of(
        TOOLS.resolve("jdb").toString(),
        "-connect",
        "com.sun.jdi.SocketAttach:hostname=127.0.0.1,port=" + place.port(),
        "-sourcepath",
        sourcePath());
  }

  /** All folders of the activity that sources may start in. */
  private String sourcePath() throws IOException {
    try (var folders = Files.list(place.order().activity())) {
      return folders
          .filter(Files::isDirectory)
          .map(Path::toString)
          .sorted()
          .collect(Collectors.joining(File.pathSeparator));
    }
  }

  @Override
  public List<String> connection() {
    return List.of(
        "attach a Java debugger (JDWP over a socket) to host 127.0.0.1, port " + place.port(),
        "breakpoint: " + String.join(", ", breakpoints()));
  }

  private List<String> breakpoints() {
    return place.order().methods().stream()
        .map(method -> place.order().className() + "." + method)
        .toList();
  }

  @Override
  public Path folder() {
    return place.folder();
  }

  @Override
  public void letContinue() {
    // Opened for both directions, which does not wait.
    try (RandomAccessFile pipe = new RandomAccessFile(place.pipe().toFile(), "rw")) {
      Thread.sleep(PAUSE.toMillis());
    } catch (IOException e) {
      throw new UncheckedIOException("the JVM cannot be released", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
