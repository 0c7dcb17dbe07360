package org.sitaf.agent.spool;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.testing.OddTrees;
import org.sitaf.agent.testing.OrdinaryUser;

/** An agent starts with an empty folder for builds, whatever the previous one left. */
@Timeout(300)
class AgentDirectoryTest {
  @TempDir private Path temporary;

  private static BuildFolders builds(AgentDirectory directory, Trash trash) throws IOException {
    return directory.builds(trash, "written", 16, 100);
  }

  private static long countIn(Path folder) throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.count();
    }
  }

  private static void awaitEmpty(Path folder) throws Exception {
    for (int i = 0; i < 3000 && countIn(folder) > 0; i++) {
      Thread.sleep(10);
    }
    assertThat(countIn(folder)).isZero();
  }

  /** Starts an agent, leaves files of a build, and starts it again. */
  static void startAfterLeftovers(Path path) throws Exception {
    Path run = Files.createDirectories(path.resolve("builds/1-1/execution/run"));
    OddTrees.createNestedFolders(run, 400);
    OddTrees.lock(run);
    OddTrees.fill(Files.createDirectory(run.resolve("many")), 20_000);
    try (AgentDirectory directory = AgentDirectory.open(path);
        Trash trash = directory.trash()) {
      builds(directory, trash);
      assertThat(path.resolve("builds")).isEmptyDirectory();
      awaitEmpty(path.resolve("trash"));
    }
  }

  @Tag("slow")
  @Test
  void startsDespiteOddTreesOfBuilds() throws Exception {
    startAfterLeftovers(temporary.resolve("agent"));
  }

  @Test
  void startsDespiteOddTreesAsAnUnprivilegedUser() throws Exception {
    Path folder = OrdinaryUser.folder(temporary);

    assertThat(OrdinaryUser.run(Starting.class, folder.toString())).contains("started");
  }

  /** Main program for an unprivileged user, who can read the classes of the agent only. */
  static final class Starting {
    public static void main(String[] arguments) throws Exception {
      Path path = Path.of(arguments[0], "agent");
      Path run = Files.createDirectories(path.resolve("builds/1-1/execution/run"));
      OddTrees.createNestedFolders(run, 400);
      OddTrees.lock(run);
      Files.setPosixFilePermissions(run, PosixFilePermissions.fromString("---------"));
      try (AgentDirectory directory = AgentDirectory.open(path);
          Trash trash = directory.trash()) {
        builds(directory, trash);
        for (int i = 0; i < 3000 && countIn(path.resolve("trash")) > 0; i++) {
          Thread.sleep(10);
        }
        boolean clean = countIn(path.resolve("builds")) + countIn(path.resolve("trash")) == 0;
        System.out.println(clean ? "started" : "left");
      }
    }
  }

  @Test
  void limitsTheSizeOfABuildsFilesIfTheAgentIsRoot() throws Exception {
    assumeTrue(OrdinaryUser.isRoot(), "skipped: only root can mount");
    try (AgentDirectory directory = AgentDirectory.open(temporary.resolve("agent"));
        Trash trash = directory.trash()) {
      BuildFolders builds = builds(directory, trash);
      Path written = builds.create("1-1").resolve("written");
      assumeTrue(
          Files.getFileStore(written).type().equals("tmpfs"), "skipped: this root may not mount");

      assertThatThrownBy(() -> Files.write(written.resolve("large"), new byte[17 << 20]))
          .hasMessageContaining("No space left");
      assertThatThrownBy(() -> OddTrees.fill(written, 101)).isInstanceOf(IOException.class);
      builds.remove("1-1");
      assertThat(builds.of("1-1")).doesNotExist();

      // A killed agent removes nothing.
      builds.create("1-2");
      builds(directory, trash);
      assertThat(builds.of("1-2")).doesNotExist();
      assertThat(Files.readString(Path.of("/proc/self/mountinfo")))
          .doesNotContain(temporary.toString());
      awaitEmpty(temporary.resolve("agent/trash"));
    }
  }

  @Test
  void theFolderIsPrivate() throws IOException {
    Path path = Files.createDirectory(temporary.resolve("agent"));
    Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rwxrwxr-x"));

    AgentDirectory.open(path).close();

    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path)))
        .isEqualTo("rwx------");
  }
}
