package org.sitaf.agent.sandbox;

import java.net.URISyntaxException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import org.sitaf.agent.sandbox.Escapes.End;
import org.sitaf.agent.sandbox.cgroup.ControlGroups;

/** A process of its own that confines a command; prints what it says and how it ends. */
final class SandboxProgram {
  /** Property: without the filter of system calls. */
  static final String UNFILTERED = "unfiltered";

  private SandboxProgram() {}

  /** FOLDER READABLE COMMAND...; prints "started" before the command's end is awaited. */
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
    System.out.println("ended " + end.code() + " " + end.broken().orElse("within its limits"));
  }

  /** The words of a command that runs it. */
  static List<String> command() throws URISyntaxException {
    return command(false);
  }

  static List<String> command(boolean unfiltered) throws URISyntaxException {
    return List.of(
        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-D" + UNFILTERED + "=" + unfiltered,
        "-cp",
        // The folders of classes alone; an ordinary user may not read the libraries.
        folderOf(Sandbox.class) + ":" + folderOf(SandboxProgram.class),
        SandboxProgram.class.getName());
  }

  static Path folderOf(Class<?> type) throws URISyntaxException {
    return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI())
        .toAbsolutePath();
  }
}
