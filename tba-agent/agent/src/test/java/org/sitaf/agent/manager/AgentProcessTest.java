package org.sitaf.agent.manager;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.v1.AttemptRef;

/** The agent as a separate process. */
@Tag("slow")
@Timeout(300)
class AgentProcessTest {
  private static final AttemptRef ATTEMPT = FakeServer.attempt("b-1", 1, 17);

  @TempDir private Path directory;
  private String classPath = System.getProperty("java.class.path");
  private FakeServer server;
  private Process agent;

  private BufferedReader start(String... more) throws IOException {
    server = FakeServer.start();
    return startAgent(more);
  }

  private BufferedReader startAgent(String... more) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                classPath,
                "org.sitaf.agent.AgentMain",
                "--server",
                server.address(),
                "--name",
                "tester",
                "--directory",
                directory.resolve("agent").toString(),
                "--sandbox",
                "off",
                "--runtimes",
                System.getProperty("sitaf.runtimes")));
    command.addAll(List.of(more));
    ProcessBuilder builder = new ProcessBuilder(command).redirectError(errors().toFile());
    builder.environment().put("SITAF_ENROLMENT_TOKEN", FakeAuthentication.ENROLMENT);
    agent = builder.start();
    return agent.inputReader();
  }

  private Path errors() {
    return directory.resolve("errors");
  }

  @AfterEach
  void stop() throws InterruptedException {
    agent.destroyForcibly().waitFor();
    server.close();
  }

  @Test
  void printsOneLineAfterRegistrationAndStops() throws Exception {
    BufferedReader output = start();

    assertThat(output.readLine())
        .isEqualTo("registered tester at " + server.address() + " (server test)");
    // Process.destroy would also close our end of its output.
    agent.toHandle().destroy();
    assertThat(agent.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(output.readLine()).isNull();
  }

  @Test
  void endsAfterItsInstallationWasReplaced() throws Exception {
    Path classes = directory.resolve("classes");
    Path compiled = Path.of("target", "classes").toAbsolutePath();
    try (Stream<Path> files = Files.walk(compiled)) {
      for (Path file : files.sorted().toList()) {
        Files.copy(file, classes.resolve(compiled.relativize(file).toString()));
      }
    }
    classPath = classPath.replace(compiled.toString(), classes.toString());
    assertThat(classPath).contains(classes.toString());
    BufferedReader output = start();
    output.readLine();
    Folders.delete(classes);

    agent.toHandle().destroy();
    assertThat(agent.waitFor(60, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void endsWithItsLauncher() throws Exception {
    start("--stop-with-stdin").readLine();
    agent.getOutputStream().close();

    assertThat(agent.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(agent.exitValue()).isZero();
  }

  @Test
  void laterOptionsOverrideTheLaunchersDefaults() throws Exception {
    BufferedReader output =
        start("--bridge-command", "python", "--bridge", "127.0.0.1:1", "--name", "other");

    assertThat(output.readLine()).startsWith("registered other at ");
    assertThat(errors()).content().doesNotContain("picocli", "verwrit");
  }

  @Test
  void reportsAnInvalidSetting() throws Exception {
    BufferedReader output = start("--slots", "0");

    assertThat(output.readLine()).isNull();
    assertThat(agent.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(agent.exitValue()).isEqualTo(2);
    assertThat(errors()).content().isEqualTo("sitaf agent: --slots 0: expected 1 to 256\n");
  }

  @Test
  void killsProcessesThatAKilledAgentLeft() throws Exception {
    start().readLine();
    Path pidFile = directory.resolve("pid");
    server.assign(
        ATTEMPT,
        EchoActivity.withBody(
                "java.nio.file.Files.writeString(java.nio.file.Path.of(\""
                    + pidFile
                    + "\"), \"\" + ProcessHandle.current().pid());"
                    + " if (value == 2) Thread.sleep(60000); return value;")
            .caseWallSeconds(90)
            .application()
            .files());
    server.await(s -> !s.cases().isEmpty());
    long harness = Long.parseLong(Files.readString(pidFile));
    agent.destroyForcibly().waitFor();
    assertThat(isRunning(harness)).isTrue();

    startAgent().readLine();
    for (int i = 0; i < 500 && isRunning(harness); i++) {
      Thread.sleep(10);
    }
    assertThat(isRunning(harness)).isFalse();
    assertThat(server.registrations().get(1).getRunningList()).isEmpty();
  }

  private static boolean isRunning(long pid) {
    return ProcessHandle.of(pid).map(ProcessHandle::isAlive).orElse(false);
  }
}
