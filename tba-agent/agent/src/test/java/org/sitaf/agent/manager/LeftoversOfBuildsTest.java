package org.sitaf.agent.manager;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;

/** An agent continues to run builds, whatever a build left. */
@Tag("slow")
@Timeout(300)
class LeftoversOfBuildsTest {
  @TempDir private Path directory;
  private FakeServer server;
  private TestBuildAgent agent;

  private void start() throws Exception {
    server = FakeServer.start();
    AgentSettings settings =
        new AgentSettings(
            server.address(),
            ServerAccess.byToken(FakeAuthentication.ENROLMENT),
            "tester",
            "1",
            directory,
            1,
            List.of(),
            null,
            SandboxMode.AUTO,
            true,
            Set.of(),
            Map.of(),
            0,
            Duration.ofHours(1));
    agent = new TestBuildAgent(settings, EchoActivity.toolchains(), version -> {});
    server.await(s -> !s.registrations().isEmpty());
  }

  @AfterEach
  void stop() throws Exception {
    if (agent != null) {
      agent.close();
      server.close();
    }
    Folders.delete(directory.resolve("trash"));
  }

  private TestResult result(int number, EchoActivity activity) throws Exception {
    server.assign(
        FakeServer.attempt("b-" + number, 1, 16 + number), activity.application().files());
    server.await(s -> s.submitted().size() == number);
    SubmitResultRequest submitted = server.submitted().get(number - 1);
    assertThat(submitted.getFailure().getMessage()).isEmpty();
    byte[] document = submitted.getResultDescriptor().toByteArray();
    return TestResultXml.read(new ByteArrayInputStream(document), "result");
  }

  private static EchoActivity third(String python) {
    return EchoActivity.withBody(
        "if (value == 3) { new ProcessBuilder(\"python3\", \"-c\", \""
            + python.replace("\n", "\\n")
            + "\").inheritIO().start().waitFor(); } return value;");
  }

  private static void assertOnlyCase3IsError(TestResult result, String... messages) {
    assertThat(result.cases())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.PASS, Verdict.ERROR, Verdict.PASS, Verdict.PASS);
    assertThat(result.cases().get(2).message()).containsAnyOf(messages);
  }

  @Test
  void exceedingALimitFailsTheCaseAndLeavesNothing() throws Exception {
    start();

    assertOnlyCase3IsError(
        result(
            1,
            third(
                "import time\n"
                    + "for i in range(15):\n"
                    + "    try: open(f'f{i}', 'wb').write(bytes(200 << 20))\n"
                    + "    except OSError: pass\n"
                    + "time.sleep(60)")),
        "it wrote more than 512 MiB of files",
        // If the agent is root, the files are in a tmpfs, which the control group counts as memory.
        "it used more than 384 MiB of memory");
    assertOnlyCase3IsError(
        result(
            2,
            third(
                "import os, time\nfor i in range(200000):\n    try: os.mknod(str(i))\n"
                    + "    except OSError: break\ntime.sleep(60)")),
        "it wrote more than 20000 files");
    TestResult odd =
        result(
            3,
            third(
                "import os\nos.mkdir('locked')\nos.chmod('locked', 0)\n"
                    + "for i in range(400):\n    os.mkdir('d' * 200)\n    os.chdir('d' * 200)\n"));
    assertThat(odd.summary().pass()).isEqualTo(5);
    assertThat(result(4, EchoActivity.withBody("return value;")).summary().pass()).isEqualTo(5);

    for (String folder : List.of("builds", "trash")) {
      for (int i = 0; i < 3000 && !isEmpty(directory.resolve(folder)); i++) {
        Thread.sleep(10);
      }
      assertThat(directory.resolve(folder)).isEmptyDirectory();
    }
    assertThat(Files.readString(Path.of("/proc/self/mountinfo")))
        .doesNotContain(directory.toString());
  }

  private static boolean isEmpty(Path folder) throws Exception {
    try (Stream<Path> all = Files.list(folder)) {
      return all.findAny().isEmpty();
    }
  }
}
