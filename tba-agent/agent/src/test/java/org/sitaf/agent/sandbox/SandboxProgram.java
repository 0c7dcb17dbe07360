package org.sitaf.agent.sandbox;

import java.net.URISyntaxException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import org.sitaf.agent.sandbox.Escapes.End;
import org.sitaf.agent.sandbox.cgroup.ControlGroups;

/** Main program that confines a command and prints its output and exit code. */
final class SandboxProgram {
  /** System property that disables the system call filter. */
  static final String UNFILTERED = "unfiltered";

  private SandboxProgram() {}

  /** Arguments: FOLDER READABLE COMMAND...; prints "started" before it waits for the command. */
  public static void main(String[] arguments) throws Exception {
    Sandbox sandbox =
        Boolean.getBoolean(UNFILTERED)
            ? Bubblewrap.find(false, ControlGroups.none("switched off by a test"), false)
            : SandboxMode.REQUIRED.open();
    System.out.println(sandbox.description());
    Path folder = Path.of(arguments[0]);
    List<String> command = Arrays.asList(arguments).subList(2, arguments.length);
    Confinement confinement =
        Escapes.confinement(folder, new ProcessLimits(512, 64, 256, Duration.ofMinutes(1)), command)
            .reading(List.of(Path.of(arguments[1])));
    End end = Escapes.run(sandbox, confinement);
    System.out.println(end.output());
    System.out.println(end.errors());
    System.out.println(
        "ended " + end.code() + " " + end.exceededLimit().orElse("within its limits"));
  }

  /** The command line that starts this program. */
  static List<String> command() throws URISyntaxException {
    return command(false);
  }

  static List<String> command(boolean unfiltered) throws URISyntaxException {
    return List.of(
        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-D" + UNFILTERED + "=" + unfiltered,
        "-cp",
        // Without the libraries, which an unprivileged user may not be able to read.
        folderOf(Sandbox.class) + ":" + folderOf(SandboxProgram.class),
        SandboxProgram.class.getName());
  }

  static Path folderOf(Class<?> type) throws URISyntaxException {
    return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI())
        .toAbsolutePath();
  }
}
