package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.core.verdict.TestResult;

/** The tests without a sandbox, repeated in one, and tests of its restrictions. */
@Tag("slow")
class SandboxedComponentsTest extends HostileComponentsTest {
  @Override
  Sandbox sandbox() throws IOException {
    assumeTrue(
        !SandboxMode.AUTO.open().kind().equals("none"),
        "skipped: bubblewrap is not available: " + SandboxMode.AUTO.open().description());
    return SandboxMode.REQUIRED.open();
  }

  private void everyCasePasses(String body) {
    TestResult result = result(EchoActivity.withBody(body));

    assertThat(result.summary().pass()).describedAs(recording.logText()).isEqualTo(5);
  }

  private void assertNextBuildPasses() {
    EchoActivity next = EchoActivity.withBody("return value;");
    next.application();
    directory = directory.resolve("next");
    assertThat(result(next).summary().pass()).isEqualTo(5);
  }

  @Test
  void logsTheSandbox() {
    everyCasePasses("return value;");

    assertThat(recording.logText()).contains("[sitaf] bubblewrap ");
  }

  @Test
  void aForkBombFailsOnlyItsCase() {
    TestResult result =
        result(
            EchoActivity.withBody(
                    """
                    if (value == 3) {
                      new ProcessBuilder("sh", "-c", "b() { b | b & }; b; sleep 100").start();
                      for (;;) {
                        Thread.sleep(1000);
                      }
                    }
                    return value;\
                    """)
                .caseWallSeconds(2));

    // The process waits, unless the bomb used up the processes before the JVM had started.
    assertOnlyCase3IsError(result, "");
    assertThat(result.cases().get(2).message())
        .containsPattern("no answer within 2 s|process/resource limits reached");
    assertNextBuildPasses();
  }

  @Test
  void aThreadBombFailsOnlyItsCase() {
    TestResult result =
        result(
            EchoActivity.withBody(
                    """
                    if (value == 3) {
                      for (;;) {
                        new Thread(() -> { while (true) Thread.onSpinWait(); }).start();
                      }
                    }
                    return value;\
                    """)
                .caseWallSeconds(3));

    assertOnlyCase3IsError(result, "");
    assertNextBuildPasses();
  }

  @Test
  void countsMemoryOfChildProcesses() {
    TestResult result =
        result(
            EchoActivity.withBody(
                """
                if (value == 3) {
                  new ProcessBuilder("sh", "-c", "for i in 1 2 3; do (x=$(head -c 400m /dev/zero"
                      + " | tr '\\\\0' x); sleep 100) & done; wait").start().waitFor();
                }
                return value;\
                """));

    assertOnlyCase3IsError(result, "it used more than 384 MiB of memory");
    assertNextBuildPasses();
  }

  @Test
  void cannotWriteFilesOutside() throws IOException {
    Path outside = Files.writeString(directory.resolve("outside"), "untouched");
    everyCasePasses(
        """
        for (String place : new String[] {"%s", "/usr/bin/evil", "/etc/evil", "/evil",
            "/proc/sys/kernel/hostname"}) {
          try {
            java.nio.file.Files.writeString(java.nio.file.Path.of(place), "evil");
            return -1;
          } catch (java.io.IOException e) {
            // The expected value.
          }
        }
        return value;\
        """
            .formatted(outside));

    assertThat(outside).hasContent("untouched");
  }

  @Test
  void cannotModifyTheHarness() {
    everyCasePasses(
        """
        for (String entry : System.getProperty("java.class.path").split(":")) {
          java.nio.file.Path path = java.nio.file.Path.of(entry);
          if (java.nio.file.Files.isWritable(path)) {
            return -1;
          }
        }
        return value;\
        """);
  }

  @Test
  void filesOfTheAgentCannotBeRead() throws IOException {
    Path key = Files.writeString(directory.resolve("agent.key"), "secret");
    everyCasePasses(
        """
        return java.nio.file.Files.exists(java.nio.file.Path.of("%s"))
            || java.nio.file.Files.isReadable(java.nio.file.Path.of("/etc/shadow"))
            || java.nio.file.Files.exists(java.nio.file.Path.of("/root/.ssh")) ? -1 : value;\
        """
            .formatted(key));
  }

  @Test
  void cannotSeeOrKillOtherProcesses() {
    everyCasePasses(
        """
        long agent = %d;
        new ProcessBuilder("sh", "-c", "kill -9 " + agent + "; kill -9 1; kill -9 $(ls /proc"
            + " | grep -E '^[0-9]+$' | grep -v -E '^(1|" + ProcessHandle.current().pid() + ")$')")
            .start().waitFor();
        return ProcessHandle.allProcesses().count() < 10 ? value : -1;\
        """
            .formatted(ProcessHandle.current().pid()));
  }

  @Test
  void killingTheParentProcessHasNoEffect() {
    TestResult result =
        result(
            EchoActivity.withBody(
                """
                if (value == 3) {
                  long parent = ProcessHandle.current().parent().get().pid();
                  new ProcessBuilder("kill", "-9", "" + parent, "-1").start().waitFor();
                  throw new Exception("still here");
                }
                return value;\
                """));

    assertThat(result.summary().pass()).isEqualTo(4);
    assertThat(result.summary().error()).isEqualTo(1);
    assertNextBuildPasses();
  }

  @Test
  void thereIsNoNetwork() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      everyCasePasses(
          """
          try (var socket = new java.net.Socket("127.0.0.1", %d)) {
            return -1;
          } catch (java.io.IOException e) {
            return value;
          }\
          """
              .formatted(server.getLocalPort()));
    }
  }

  @Test
  void aComponentMayDeleteItsFolder() {
    everyCasePasses(
        """
        new ProcessBuilder("sh", "-c", "rm -rf $PWD $HOME $TMPDIR /tmp/* ~").start().waitFor();
        return value;\
        """);
    assertNextBuildPasses();
  }

  @Test
  void temporaryFilesWork() {
    everyCasePasses(
        """
        java.nio.file.Path file = java.nio.file.Files.createTempFile("a", "b");
        java.nio.file.Files.writeString(java.nio.file.Path.of("/tmp/shared"), "x");
        return java.nio.file.Files.readString(file).isEmpty() ? value : -1;\
        """);
  }

  @Test
  void fileSizesAreLimited() {
    TestResult result =
        result(
            EchoActivity.withBody(
                """
                if (value == 3) {
                  try (var out = new java.io.FileOutputStream("big")) {
                    byte[] block = new byte[1 << 20];
                    for (int i = 0; i < 400; i++) {
                      out.write(block);
                    }
                  }
                }
                return value;\
                """));

    assertOnlyCase3IsError(result, "");
  }

  @Test
  void runsAsAnUnknownUser() {
    everyCasePasses(
        """
        var status = java.nio.file.Files.readAllLines(java.nio.file.Path.of("/proc/self/status"));
        return status.stream().anyMatch(line -> line.equals("CapEff:\\t0000000000000000"))
            && status.stream().anyMatch(line -> line.equals("NoNewPrivs:\\t1")) ? value : -1;\
        """);
  }
}
