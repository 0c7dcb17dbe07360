package org.sitaf.agent.sandbox;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.testing.OrdinaryUser;

/** Kills processes that write more than allowed, whatever kind of files they write. */
@Tag("slow")
@Timeout(300)
class DiskWatchTest {
  /** 16 MiB for each file, so 32 MiB for all files. */
  private static final ProcessLimits LIMITS = new ProcessLimits(256, 50, 16, Duration.ofMinutes(1));

  private static final String PYTHON_LIMIT = "it wrote more than 32 MiB of files";

  @TempDir private Path directory;

  private static String exceededLimit(Path folder, String program) throws Exception {
    Path working = Files.createDirectories(folder.resolve("run"));
    Path temporary = Files.createDirectories(folder.resolve("tmp"));
    Path more = Files.createDirectories(folder.resolve("more"));
    // Files that exist before the start do not count.
    Files.write(more.resolve("before"), new byte[40 << 20]);
    Confinement confinement =
        Confinement.of(java.util.List.of("python3", "-c", program), working, temporary, LIMITS)
            .writing(java.util.List.of(more));
    try (ConfinedProcess process = SandboxMode.REQUIRED.open().start(confinement)) {
      boolean ended = process.awaitEnd(Duration.ofSeconds(60));
      if (process.exceededLimit().isPresent()) {
        return process.exceededLimit().get();
      }
      return ended ? "none " + new String(process.errors().readAllBytes()) : "still running";
    } finally {
      Folders.delete(folder);
    }
  }

  /** Runs the program as the user of the tests and as an unprivileged user. */
  private void assertKilled(String expected, String program) throws Exception {
    assumeTrue(isSandboxThere(), "skipped: bubblewrap is not installed");
    assertThat(exceededLimit(directory.resolve("own"), program)).startsWith(expected);
    if (OrdinaryUser.isRoot()) {
      Path folder = OrdinaryUser.folder(directory);
      assertThat(OrdinaryUser.run(Confined.class, folder.toString(), program)).startsWith(expected);
    }
  }

  private static boolean isSandboxThere() {
    try {
      SandboxMode.REQUIRED.open();
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** Main program for an unprivileged user. */
  static final class Confined {
    public static void main(String[] arguments) throws Exception {
      System.out.println(exceededLimit(Path.of(arguments[0], "own"), arguments[1]));
    }
  }

  @Test
  void countsManyFiles() throws Exception {
    assertKilled(
        PYTHON_LIMIT,
        "import time\nfor i in range(10):\n"
            + "    open(f'f{i}', 'wb').write(bytes(15 << 20))\ntime.sleep(90)");
  }

  @Test
  void countsSparseFilesWithTheirFullLength() throws Exception {
    assertKilled(
        PYTHON_LIMIT,
        "import time\nfor i in range(10):\n"
            + "    open(f'f{i}', 'wb').truncate(15 << 20)\ntime.sleep(90)");
  }

  @Test
  void countsSharedWritableFolders() throws Exception {
    assertKilled(
        PYTHON_LIMIT,
        "import time\nfor i in range(10):\n"
            + "    open(f'../more/f{i}', 'wb').write(bytes(15 << 20))\ntime.sleep(90)");
  }

  @Test
  void countsDeletedFilesThatAreOpen() throws Exception {
    assertKilled(
        PYTHON_LIMIT,
        "import os, time\nkept = []\nfor i in range(4):\n"
            + "    kept.append(open('f', 'wb'))\n    os.unlink('f')\n"
            + "    kept[-1].write(bytes(15 << 20))\n    kept[-1].flush()\ntime.sleep(90)");
  }

  @Test
  void killsAProcessThatHidesItsOpenFilesFromAnUnprivilegedAgent() throws Exception {
    assumeTrue(isSandboxThere(), "skipped: bubblewrap is not installed");
    Path folder = OrdinaryUser.folder(directory);

    assertThat(
            OrdinaryUser.run(
                Confined.class,
                folder.toString(),
                "import ctypes, time\nctypes.CDLL(None).prctl(4, 0, 0, 0, 0)\ntime.sleep(90)"))
        .startsWith("it prevents the agent from listing its open files");
  }

  @Test
  void countsDeletedFilesThatAreMapped() throws Exception {
    assertKilled(
        PYTHON_LIMIT,
        "import mmap, os, time\nkept = []\nfor i in range(4):\n"
            + "    f = open('f', 'w+b')\n    os.unlink('f')\n    f.truncate(15 << 20)\n"
            + "    kept.append(mmap.mmap(f.fileno(), 15 << 20))\n    f.close()\ntime.sleep(90)");
  }

  @Test
  void limitsTheNumberOfFiles() throws Exception {
    assertKilled(
        "it wrote more than 20000 files",
        "import os, time\nfor i in range(200000):\n    os.mknod(f'{i}')\ntime.sleep(90)");
  }

  @Test
  void countsFilesInAnUnreadableFolder() throws Exception {
    assertKilled(
        PYTHON_LIMIT,
        "import os, time\nos.mkdir('d')\nf = [open(f'd/{i}', 'wb') for i in range(4)]\n"
            + "os.chmod('d', 0)\n[x.write(bytes(15 << 20)) for x in f]\ntime.sleep(90)");
  }

  @Test
  void countsFilesInDeeplyNestedFolders() throws Exception {
    assertKilled(
        PYTHON_LIMIT,
        "import os, time\nfor i in range(400):\n    os.mkdir('d' * 200)\n    os.chdir('d' * 200)\n"
            + "for i in range(4):\n    open(f'{i}', 'wb').write(bytes(15 << 20))\ntime.sleep(90)");
  }

  @Test
  void limitsTheDepthOfFolders() throws Exception {
    assertKilled(
        "it nested folders more than 512 deep",
        "import os, time\nfor i in range(2000):\n    os.mkdir('d')\n    os.chdir('d')\n"
            + "time.sleep(90)");
  }

  @Test
  void leavesAProcessWithinItsLimitsRunning() throws Exception {
    assertKilled(
        "none",
        "import os, time\nos.symlink('/', 'root')\nos.mkfifo('pipe')\n"
            + "for i in range(300):\n    os.mkdir('d')\n    os.chdir('d')\n"
            + "open('f', 'wb').write(bytes(8 << 20))\ntime.sleep(1)");
  }
}
