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

/** Programs in C that try to leave a sandbox, and sandboxes to try them in. */
final class Escapes {
  static final Duration PATIENCE = Duration.ofSeconds(60);

  private Escapes() {}

  /** How a program ended, and for which limit. */
  record End(int code, String output, String errors, Optional<String> broken) {}

  /** What bounds the memory of a sandbox. */
  enum Bound {
    /** As this machine gives them, which may be none. */
    GROUPS,
    /** As where a machine gives none. */
    WATCH;

    ControlGroups groups() {
      return this == GROUPS
          ? ControlGroups.ofThisMachine()
          : ControlGroups.none("switched off by a test");
    }

    Sandbox sandbox() throws IOException {
      ControlGroups groups = groups();
      assumeTrue(this == WATCH || groups.bindMemory(), () -> "skipped: " + groups.description());
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
      String said = new String(gcc.getInputStream().readAllBytes());
      if (gcc.waitFor() != 0) {
        throw new IOException(said);
      }
    } catch (IOException e) {
      assumeTrue(
          !String.valueOf(e.getMessage()).contains("Cannot run program"),
          "skipped: gcc is not installed");
      throw e;
    }
    return program;
  }

  /** A confinement of that command, in folders of its own. */
  static Confinement confinement(Path folder, ProcessLimits limits, List<String> command)
      throws IOException {
    // Another user than this one must pass it.
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
    ToolEnd end = ToolEnd.of(process, PATIENCE);
    return new End(end.code(), end.output(), end.errors(), process.brokenLimit());
  }
}
