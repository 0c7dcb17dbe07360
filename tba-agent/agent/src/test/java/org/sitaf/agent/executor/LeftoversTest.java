package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Files that a component leaves affect only the verdict of the case that exceeded a limit. */
@Tag("slow")
@Timeout(300)
class LeftoversTest {
  /** The path of JaCoCo's record, which a component can find out, too. */
  private static final String COVERAGE =
      """
      java.nio.file.Path data = null;
      for (String argument : java.lang.management.ManagementFactory.getRuntimeMXBean()
          .getInputArguments()) {
        if (argument.contains("destfile=")) {
          data = java.nio.file.Path.of(argument.replaceAll(".*destfile=([^,]*),.*", "$1"));
        }
      }
      """;

  @TempDir private Path directory;
  private final Recording recording = new Recording();

  @AfterEach
  void deleteDeepFolders() throws IOException {
    Folders.delete(directory.resolve("build"));
  }

  private TestResult result(String body) throws IOException {
    // The limit of time must not come first on a loaded machine.
    return result(
        EchoActivity.withBody(body).caseWallSeconds(60), EchoActivity.settings(sandbox()));
  }

  private TestResult result(EchoActivity activity, BuildSettings settings) {
    BuildRun run =
        new BuildRun(activity.application(), directory.resolve("build"), settings, recording);
    return ((Completed) run.run()).result();
  }

  private static Sandbox sandbox() throws IOException {
    assumeTrue(
        !SandboxMode.AUTO.open().kind().equals(Sandbox.NONE),
        "skipped: bubblewrap is not available");
    return SandboxMode.REQUIRED.open();
  }

  private static String python(String program) {
    return "new ProcessBuilder(\"python3\", \"-c\", \""
        + program.replace("\n", "\\n").replace("\"", "\\\"")
        + "\").inheritIO().start().waitFor();";
  }

  private void everyCasePasses(TestResult result) {
    assertThat(result.summary().pass()).describedAs(recording.logText()).isEqualTo(5);
  }

  private void assertOnlyCase3IsError(TestResult result, String message) {
    assertThat(result.cases())
        .describedAs(recording.logText())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.PASS, Verdict.ERROR, Verdict.PASS, Verdict.PASS);
    assertThat(result.cases().get(2).message()).contains(message);
  }

  @Test
  void deepFoldersInTheCoverageFolderAffectNoVerdict() throws Exception {
    TestResult result =
        result(
            COVERAGE
                + "ProcessBuilder nest = new ProcessBuilder(\"python3\", \"-c\","
                + " \"import os\\nfor i in range(400):\\n    os.mkdir('d' * 200)\\n"
                + "    os.chdir('d' * 200)\\n\");"
                + "if (value == 2) nest.directory(data.getParent().toFile()).start().waitFor();"
                + "return value == 3 ? 99 : value;");

    assertThat(result.summary().fail()).describedAs(recording.logText()).isEqualTo(1);
    assertThat(result.summary().pass()).isEqualTo(4);
    assertThat(result.coverage()).isNotNull();
  }

  @Test
  void doesNotReadAPipeOrLinkInsteadOfCoverageData() throws Exception {
    everyCasePasses(
        result(
            COVERAGE
                + """
                if (value == 1) {
                  java.nio.file.Files.deleteIfExists(data);
                  new ProcessBuilder("mkfifo", data.toString()).start().waitFor();
                  var parent = data.getParent();
                  for (String name : new String[] {"a", "b", "c"}) {
                    java.nio.file.Files.createDirectory(parent.resolve(name));
                  }
                  java.nio.file.Files.createSymbolicLink(parent.resolve("a/jacoco.exec"),
                      java.nio.file.Path.of("/dev/zero"));
                  java.nio.file.Files.createDirectory(parent.resolve("b/jacoco.exec"));
                  // A record that claims to have two billion probes.
                  java.nio.file.Files.write(parent.resolve("c/jacoco.exec"), new byte[] {
                      1, (byte) 0xC0, (byte) 0xC0, 0x10, 7, 0x11, 0, 0, 0, 0, 0, 0, 0, 1,
                      0, 14, 'd', 'e', 'm', 'o', '/', 'C', 'o', 'm', 'p', 'o', 'n', 'e', 'n', 't',
                      (byte) 0xFF, (byte) 0xFF, (byte) 0xFF, (byte) 0xFF, 7});
                }
                return value;\
                """));
  }

  @Test
  void tooLargeFilesFailTheirCase() throws Exception {
    assertOnlyCase3IsError(
        result(
            "if (value == 3) { "
                + python(
                    "import time\nfor i in range(3):\n"
                        + "    open(f'f{i}', 'wb').write(bytes(200 << 20))\ntime.sleep(60)")
                + " } return value;"),
        "it wrote more than 512 MiB of files");
  }

  @Test
  void sparseFilesFailTheirCase() throws Exception {
    assertOnlyCase3IsError(
        result(
            "if (value == 3) { "
                + python(
                    "import time\nfor i in range(15):\n"
                        + "    open(f'f{i}', 'wb').truncate(200 << 20)\ntime.sleep(60)")
                + " } return value;"),
        "it wrote more than 512 MiB of files");
  }

  @Test
  void tooManyFilesFailTheirCase() throws Exception {
    assertOnlyCase3IsError(
        result(
            "if (value == 3) { "
                + python(
                    "import os, time\nfor i in range(200000):\n    os.mknod(f'{i}')\n"
                        + "time.sleep(60)")
                + " } return value;"),
        "it wrote more than 20000 files");
  }

  @Test
  void oddTreesDoNotPreventTheNextProcess() throws Exception {
    assertOnlyCase3IsError(
        result(
            "if (value == 3) { "
                + python(
                    "import os\n"
                        + "os.mkdir('locked')\n"
                        + "os.chmod('locked', 0)\n"
                        + "os.mkfifo('pipe')\n"
                        + "for i in range(400):\n"
                        + "    os.mkdir('d' * 200)\n"
                        + "    os.chdir('d' * 200)\n")
                + "System.exit(7); } return value;"),
        "exit code 7");
  }

  @Test
  void limitsTheTotalTimeOfAllCases() throws Exception {
    TestResult result =
        result(
            EchoActivity.withBody("Thread.sleep(value == 1 ? 0 : 9000); return value;"),
            EchoActivity.settings(sandbox()).within(Duration.ofSeconds(8)));

    assertThat(result.cases().get(0).verdict()).isEqualTo(Verdict.PASS);
    assertThat(result.summary().dont()).isEqualTo(4);
    assertThat(result.cases().get(4).message())
        .isEqualTo("the cases exceeded their total time of 8 s");
  }
}
