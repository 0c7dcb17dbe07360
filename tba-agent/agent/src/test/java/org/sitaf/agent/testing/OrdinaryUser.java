package org.sitaf.agent.testing;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Runs a class as an unprivileged user if the tests run as root. */
public final class OrdinaryUser {
  private static final String NOBODY = "65534";

  private OrdinaryUser() {}

  /** A folder that the unprivileged user may write. */
  public static Path folder(Path parent) throws IOException {
    assumeTrue(isRoot(), "skipped: only root can become another user");
    for (Path on = parent; on != null && !on.equals(Path.of("/tmp")); on = on.getParent()) {
      Files.setPosixFilePermissions(on, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
    Path folder = Files.createDirectory(parent.resolve("of-nobody"));
    Files.setAttribute(folder, "unix:uid", Integer.parseInt(NOBODY));
    return folder;
  }

  /** Whether the tests run as root. */
  public static boolean isRoot() throws IOException {
    return Integer.valueOf(0).equals(Files.getAttribute(Path.of("/proc/self"), "unix:uid"));
  }

  /** Runs the main method of a test class and returns its output. */
  public static String run(Class<?> main, String... arguments)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(
            List.of(
                "setpriv",
                "--reuid=" + NOBODY,
                "--regid=" + NOBODY,
                "--clear-groups",
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx128m",
                "-cp",
                classes(main) + ":" + classes(org.sitaf.agent.AgentMain.class),
                main.getName()));
    command.addAll(List.of(arguments));
    Process process =
        new ProcessBuilder(command)
            .directory(Path.of("/").toFile())
            .redirectErrorStream(true)
            .start();
    try {
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      if (!process.waitFor(60, TimeUnit.SECONDS) || process.exitValue() != 0) {
        throw new IOException(output);
      }
      return output;
    } finally {
      process.destroyForcibly();
    }
  }

  private static String classes(Class<?> some) {
    return some.getProtectionDomain().getCodeSource().getLocation().getPath();
  }
}
