package org.sitaf.agent.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import org.sitaf.agent.spool.SystemTool;

/** Creates trees that a component may leave and that Java's file API cannot handle. */
public final class OddTrees {
  private static final Duration TIMEOUT = Duration.ofSeconds(60);

  private OddTrees() {}

  /** Nested folders with names of 200 characters. */
  public static void createNestedFolders(Path folder, int depth)
      throws IOException, InterruptedException {
    python(
        "import os, sys\n"
            + "os.chdir(sys.argv[1])\n"
            + "for i in range(int(sys.argv[2])):\n"
            + "    os.mkdir('d' * 200)\n"
            + "    os.chdir('d' * 200)\n"
            + "open('file', 'w').close()\n",
        folder.toString(),
        Integer.toString(depth));
  }

  /** Empty files. */
  public static void fill(Path folder, int files) throws IOException, InterruptedException {
    python(
        "import os, sys\n"
            + "for i in range(int(sys.argv[2])):\n"
            + "    os.mknod(f'{sys.argv[1]}/file{i}')\n",
        folder.toString(),
        Integer.toString(files));
  }

  /** A non-empty folder without permissions. */
  public static Path lock(Path folder) throws IOException {
    Path locked = Files.createDirectories(folder.resolve("locked/inner")).getParent();
    Files.writeString(locked.resolve("file"), "x");
    Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("---------"));
    return locked;
  }

  private static void python(String program, String... arguments)
      throws IOException, InterruptedException {
    List<String> command = new java.util.ArrayList<>(List.of("python3", "-c", program));
    command.addAll(List.of(arguments));
    SystemTool.run(command, TIMEOUT);
  }
}
