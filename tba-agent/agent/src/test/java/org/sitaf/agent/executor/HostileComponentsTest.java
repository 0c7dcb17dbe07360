package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildOutcome.Cancelled;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** A hostile component fails its own case only; the other cases have results. */
@Tag("slow")
@Timeout(300)
class HostileComponentsTest {
  @TempDir Path directory;
  final Recording recording = new Recording();

  Sandbox sandbox() throws IOException {
    return SandboxMode.OFF.open();
  }

  BuildRun run(EchoActivity activity) {
    try {
      return start(activity);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private BuildRun start(EchoActivity activity) throws IOException {
    return new BuildRun(
        activity.application(),
        directory.resolve("build"),
        EchoActivity.settings(sandbox()),
        recording);
  }

  TestResult result(EchoActivity activity) {
    return ((Completed) run(activity).run()).result();
  }

  static void assertOnlyCase3IsError(TestResult result, String message) {
    assertThat(result.cases())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.PASS, Verdict.ERROR, Verdict.PASS, Verdict.PASS);
    assertThat(result.cases().get(2).message()).contains(message);
    assertThat(result.cases().get(2).values()).containsExactly("3");
    assertThat(result.cases().get(2).expected()).hasSize(1);
  }

  @Test
  void reportsTheExitCodeAndLastLineOfACrash() {
    TestResult result =
        result(
            EchoActivity.withBody(
                "if (value == 3) { System.err.println(\"battery empty\"); System.exit(7); }"
                    + " return value;"));

    assertOnlyCase3IsError(result, "exit code 7: battery empty");
  }

  @Test
  void anEarlyExitWithCodeZeroIsAnError() {
    TestResult result =
        result(EchoActivity.withBody("if (value == 3) System.exit(0); return value;"));

    assertOnlyCase3IsError(result, "exit code 0");
  }

  @Test
  void namesTheSignalOfACrash() {
    TestResult result =
        result(
            EchoActivity.withBody(
                "if (value == 3) { new ProcessBuilder(\"kill\", \"-9\", \"\" +"
                    + " ProcessHandle.current().pid()).start().waitFor(); Thread.sleep(9999); }"
                    + " return value;"));

    assertOnlyCase3IsError(result, "signal 9 (SIGKILL)");
  }

  @Test
  void aHangIsAnErrorAfterTheTimeout() {
    TestResult result =
        result(
            EchoActivity.withBody("while (value == 3) { Thread.onSpinWait(); } return value;")
                .caseWallSeconds(1));

    assertOnlyCase3IsError(result, "no answer within 1 s, at ");
    assertThat(result.cases().get(2).message()).contains("demo.Component.echo(Component.java:");
    assertThat(recording.logText()).contains("Full thread dump");
  }

  @Test
  void theTimeoutAppliesToEachCase() {
    TestResult result =
        result(EchoActivity.withBody("Thread.sleep(400); return value;").caseWallSeconds(1.5));

    assertThat(result.summary().pass()).isEqualTo(5);
  }

  @Test
  void cutsTooMuchOutput() {
    TestResult result =
        result(
            EchoActivity.withBody(
                "byte[] line = \"x\".repeat(1000).getBytes();"
                    + " for (int i = 0; i < 4000; i++) { System.out.write(line, 0, 1000); }"
                    + " return value;"));

    assertThat(result.summary().pass()).isEqualTo(5);
    assertThat(recording.logText().length()).isLessThan((4 << 20) + 10_000);
    assertThat(recording.logText()).contains("output of the test application is cut here");
  }

  @Test
  void replacesInvalidUtf8() {
    TestResult result =
        result(
            EchoActivity.withBody(
                "System.out.write(0xFF); System.out.write(0xC3); System.out.println();"
                    + " return value;"));

    assertThat(result.summary().pass()).isEqualTo(5);
    assertThat(recording.logText()).contains("\uFFFD");
  }

  @Test
  void afterTwentyCrashesInARowTheRestIsNotExecuted() {
    TestResult result = result(EchoActivity.withBody("System.exit(5); return value;").cases(25));

    assertThat(result.summary().error()).isEqualTo(20);
    assertThat(result.summary().dont()).isEqualTo(5);
    assertThat(result.cases().get(24).message())
        .contains("20 test applications in a row ended in their first case", "exit code 5");
  }

  @Test
  void reportsWhyATestApplicationCannotContinue() {
    TestResult result =
        result(
            EchoActivity.withBody(
                "if (value == 4) throw new IllegalStateException(\"the arm is gone\");"
                    + " return value;"));

    assertThat(result.summary().pass()).isEqualTo(3);
    assertThat(result.summary().dont()).isEqualTo(2);
    assertThat(result.cases().get(3).message()).isEqualTo("the arm is gone");
  }

  @Test
  void aComponentThatExitsWithTheRuntimesCodeIsAnError() {
    TestResult result =
        result(EchoActivity.withBody("if (value == 3) System.exit(3); return value;"));

    assertOnlyCase3IsError(result, "exit code 3");
  }

  @Test
  void aFailedStartIsNotTheFaultOfACase() {
    TestResult result =
        result(
            EchoActivity.withComponent(
                "package demo; public class Component {"
                    + " static { System.exit(9); }"
                    + " public int echo(int value) { return value; } }"));

    assertThat(result.summary().dont()).isEqualTo(5);
    assertThat(result.cases().get(0).message())
        .contains("ended before its first case with exit code 9");
  }

  @Test
  void exceedingTheMemoryLimitFailsOnlyItsCase() {
    TestResult result =
        result(
            EchoActivity.withBody(
                "if (value == 3) { try { var all = new java.util.ArrayList<long[]>();"
                    + " while (true) all.add(new long[1 << 20]); }"
                    + " catch (OutOfMemoryError e) { throw new Exception(\"no memory\"); } }"
                    + " return value;"));

    assertOnlyCase3IsError(result, "no memory");
  }

  @Test
  void killsBackgroundProcessesAfterTheBuild() throws Exception {
    String seconds = "1000." + ProcessHandle.current().pid() + getClass().getSimpleName().length();
    TestResult result =
        result(
            EchoActivity.withBody(
                "if (value == 2) { new ProcessBuilder(\"sh\", \"-c\", \"setsid sleep "
                    + seconds
                    + " & sleep 0.2\").start().waitFor(); } return value;"));

    assertThat(result.summary().pass()).isEqualTo(5);
    for (int i = 0; i < 100 && isRunning(seconds); i++) {
      Thread.sleep(20);
    }
    assertThat(isRunning(seconds)).isFalse();
  }

  @Test
  void aCancelledBuildEndsAtOnceWithItsProcesses() throws Exception {
    BuildRun run = run(EchoActivity.withBody("if (value == 2) Thread.sleep(60000); return value;"));
    CompletableFuture<BuildOutcome> outcome = CompletableFuture.supplyAsync(run::run);
    recording.awaitCases(1);
    long cancelled = System.nanoTime();
    run.cancel("enough");

    assertThat(outcome.get(10, TimeUnit.SECONDS)).isEqualTo(new Cancelled("enough"));
    assertThat(Duration.ofNanos(System.nanoTime() - cancelled)).isLessThan(Duration.ofSeconds(20));
    List<String> left =
        ProcessHandle.current()
            .descendants()
            .filter(ProcessHandle::isAlive)
            .map(handle -> handle.info().commandLine().orElse(""))
            .filter(line -> line.contains(directory.toString()))
            .toList();
    assertThat(left).isEmpty();
  }

  @Test
  void hidesTheAgentsEnvironment() {
    TestResult result =
        result(
            EchoActivity.withBody(
                "return System.getenv().keySet().stream().allMatch(k -> java.util.Set.of(\"PATH\","
                    + " \"HOME\", \"TMPDIR\", \"LANG\", \"SITAF_RUN\", \"PWD\", \"SHLVL\", \"_\")"
                    + ".contains(k)) ? value : -1;"));

    assertThat(result.summary().pass()).isEqualTo(5);
  }

  private static boolean isRunning(String argument) {
    return ProcessHandle.allProcesses()
        .anyMatch(
            handle -> handle.info().arguments().map(List::of).orElse(List.of()).contains(argument));
  }
}
