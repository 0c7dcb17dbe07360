package org.sitaf.agent.sandbox;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sitaf.agent.sandbox.cgroup.ControlGroups;

/** Compiles C programs that try to escape, and runs them in sandboxes. */
final class Escapes {
  static final Duration TIMEOUT = Duration.ofSeconds(60);

  private Escapes() {}

  /** How a program ended, and the limit that it exceeded. */
  record End(int code, String output, String errors, Optional<String> exceededLimit) {}

  /** How the memory of a sandbox is limited. */
  enum Bound {
    /** By control groups; the test is skipped on machines without them. */
    GROUPS,
    /** By measuring the processes, as on machines without control groups. */
    WATCH;

    ControlGroups groups() {
      return this == GROUPS
          ? ControlGroups.ofThisMachine()
          : ControlGroups.none("switched off by a test");
    }

    Sandbox sandbox() throws IOException {
      ControlGroups groups = groups();
      assumeTrue(this == WATCH || groups.limitsMemory(), () -> "skipped: " + groups.description());
      try {
        return Bubblewrap.find(true, groups, true);
      } catch (SandboxMissingException e) {
        assumeTrue(false, "skipped: " + e.getMessage());
        throw e;
      }
    }
  }

  /** Compiles one of the resources. */
  static Path compiled(String name, Path folder, String... options)
      throws IOException, InterruptedException {
    Path source = folder.resolve(name + ".c");
    try (InputStream stream =
        Objects.requireNonNull(Escapes.class.getResourceAsStream("/escapes/" + name + ".c"))) {
      Files.write(source, stream.readAllBytes());
    }
    Path program = folder.resolve(name);
    List<String> command = new ArrayList<>(List.of("gcc", "-O1", "-o", program.toString()));
    command.addAll(List.of(options));
    command.addAll(List.of(source.toString(), "-lpthread", "-lrt"));
    try {
      Process gcc = new ProcessBuilder(command).redirectErrorStream(true).start();
      String output = new String(gcc.getInputStream().readAllBytes());
      if (gcc.waitFor() != 0) {
        throw new IOException(output);
      }
    } catch (IOException e) {
      assumeTrue(
          !String.valueOf(e.getMessage()).contains("Cannot run program"),
          "skipped: gcc is not installed");
      throw e;
    }
    return program;
  }

  /** A confinement of the command in new folders. */
  static Confinement confinement(Path folder, ProcessLimits limits, List<String> command)
      throws IOException {
    // The sandbox user must be able to enter it.
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
    Path working = Files.createDirectories(folder.resolve("run"));
    Path temporary = Files.createDirectories(folder.resolve("tmp"));
    Path program = Path.of(command.get(0));
    Confinement confinement = Confinement.of(command, working, temporary, limits);
    return program.startsWith(folder) ? confinement.reading(List.of(program)) : confinement;
  }

  static End run(Sandbox sandbox, Confinement confinement)
      throws IOException, InterruptedException {
    ConfinedProcess process = sandbox.start(confinement);
    ToolResult end = ToolResult.of(process, TIMEOUT);
    return new End(end.code(), end.output(), end.errors(), process.exceededLimit());
  }
}
