package org.sitaf.agent.build;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.CompilationFailed;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.build.BuildOutcome.InfrastructureFailed;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.simulation.RealBridge;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Generated test applications with the real runtime and, if it is set up, the real simulation. */
@Tag("slow")
@Timeout(300)
class GeneratedApplicationTest {
  @TempDir private Path directory;
  private final Recording recording = new Recording();

  private BuildOutcome build(TestApplication application, Simulator simulator) throws IOException {
    BuildSettings settings =
        new BuildSettings(simulator, EchoActivity.toolchains(), SandboxMode.AUTO.open(), true, "");
    return new BuildRun(application, directory.resolve("build"), settings, recording).run();
  }

  private static TestApplication infrared(Map<String, String> changed) throws IOException {
    return example("ir-sensor", changed);
  }

  private static TestApplication example(String name, Map<String, String> changed)
      throws IOException {
    Path example = Path.of(System.getProperty("sitaf.examples", ""), name);
    assumeTrue(Files.isDirectory(example), "skipped: missing " + example);
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> paths = Files.walk(example)) {
      for (Path path : paths.filter(Files::isRegularFile).toList()) {
        files.put(example.relativize(path).toString(), Files.readAllBytes(path));
      }
    }
    changed.forEach((path, text) -> files.put(path, text.getBytes(UTF_8)));
    Activity activity = Activity.read(FileTree.of(files));
    TestModel model = activity.model("GetInfraredData").orElseThrow();
    return InterfaceTestApplicationGenerator.generate(
        activity, model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
  }

  @Test
  void runsAComponentWithoutWorld() throws Exception {
    BuildOutcome outcome =
        build(
            EchoActivity.withBody(
                    "if (value == 2) throw new IllegalArgumentException(\"two\");"
                        + " if (value == 3) System.exit(7); return value == 4 ? 5 : value;")
                .generated(),
            Simulator.none());

    TestResult result = ((Completed) outcome).result();
    assertThat(result.cases())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.ERROR, Verdict.ERROR, Verdict.FAIL, Verdict.PASS);
    assertThat(result.cases().get(1).message()).contains("IllegalArgumentException", "two");
    assertThat(result.cases().get(2).message()).contains("exit code 7");
    assertThat(result.summary().times()).isNotNull();
  }

  @Test
  void explainsErrorsInAnOutdatedKeptDriver() throws Exception {
    EchoActivity activity = EchoActivity.withBody("return value;");
    String editable = "sitaf/harness/echo/ConcreteTestDriver.java";
    String generated = activity.generated().harness().text(editable).orElseThrow();
    String outdated = generated.replace("int value", "String value");
    assertThat(outdated).isNotEqualTo(generated);
    BuildOutcome outcome =
        build(
            activity.file("harness/Echo/ConcreteTestDriver.java", outdated).generated(),
            Simulator.none());

    assertThat(((CompilationFailed) outcome).diagnostics())
        .filteredOn(d -> d.file().equals("activity/harness/Echo/ConcreteTestDriver.java"))
        .isNotEmpty()
        .allSatisfy(
            d -> {
              assertThat(d.generated()).isFalse();
              assertThat(d.line()).isPositive();
              assertThat(d.message())
                  .contains(
                      "the interface may have changed since this file was kept",
                      "./sitaf harness ACTIVITY_DIR");
            });
  }

  @Test
  void all55CasesOfThePapersEvaluationPass() throws Exception {
    try (Simulator simulator =
        Simulator.started(RealBridge.command(), directory, SandboxMode.AUTO.open(), 1)) {
      BuildOutcome outcome = build(infrared(Map.of()), simulator);

      TestResult result = ((Completed) outcome).result();
      assertThat(result.summary().total()).isEqualTo(55);
      assertThat(result.cases())
          .allSatisfy(c -> assertThat(c.verdict()).as(c.toString()).isEqualTo(Verdict.PASS));
      assertThat(result.provenance().bridge()).matches("sitaf-bridge \\S+ \\(MuJoCo \\S+\\)");
      assertThat(recording.logText())
          .contains("world world/ir.world.yaml on sitaf-bridge", "serves this build only");
    }
  }

  @Test
  void keepsRecordingsOfFailedCases() throws Exception {
    String component = "component/org/sitaf/examples/ir/InfraredSensor.java";
    String source = infrared(Map.of()).activity().files().text(component).orElseThrow();
    String wrong = source.replace("double range =", "double range = 0.25 +");
    assertThat(wrong).isNotEqualTo(source);
    try (Simulator simulator =
        Simulator.started(RealBridge.command(), directory, SandboxMode.AUTO.open(), 1)) {
      BuildSettings settings =
          new BuildSettings(simulator, EchoActivity.toolchains(), SandboxMode.AUTO.open(), true, "")
              .recording(
                  new RecordingOrder(
                      directory.resolve("kept"), RecordingOrder.Cases.FAILED, 100, 64 << 20));
      BuildOutcome outcome =
          new BuildRun(
                  infrared(Map.of(component, wrong)),
                  directory.resolve("build"),
                  settings,
                  recording)
              .run();

      List<String> failed =
          ((Completed) outcome)
              .result().cases().stream()
                  .filter(c -> c.verdict() == Verdict.FAIL)
                  .map(c -> c.no() + ".glb")
                  .toList();
      assertThat(failed).isNotEmpty();
      assertThat(recording.recordings()).containsExactlyInAnyOrderElementsOf(failed);
      try (Stream<Path> kept = Files.list(directory.resolve("kept"))) {
        assertThat(kept)
            .allSatisfy(file -> assertThat(Files.readString(file, ISO_8859_1)).startsWith("glTF"))
            .extracting(file -> file.getFileName().toString())
            .containsExactlyInAnyOrderElementsOf(failed);
      }
      assertThat(recording.logText()).contains("recordings: " + failed.size() + " cases");
    }
  }

  @Test
  void aCrashedSimulatorAffectsNoVerdict() throws Exception {
    AtomicInteger seen = new AtomicInteger();
    Recording killing =
        new Recording() {
          @Override
          public synchronized void caseFinished(CaseResult result) {
            super.caseFinished(result);
            if (seen.incrementAndGet() == 10) {
              bridges().forEach(ProcessHandle::destroyForcibly);
            }
          }
        };
    try (Simulator simulator =
        Simulator.started(RealBridge.command(), directory, SandboxMode.AUTO.open(), 1)) {
      BuildSettings settings =
          new BuildSettings(
              simulator, EchoActivity.toolchains(), SandboxMode.AUTO.open(), true, "");
      String component = "component/org/sitaf/examples/ir/InfraredSensor.java";
      String source = infrared(Map.of()).activity().files().text(component).orElseThrow();
      TestApplication slow =
          infrared(
              Map.of(
                  component,
                  source.replace(
                      "double range =",
                      "java.util.concurrent.locks.LockSupport.parkNanos(50_000_000); double range"
                          + " =")));
      assertThat(slow.activity().files().text(component)).get().asString().contains("parkNanos");
      BuildOutcome outcome =
          new BuildRun(slow, directory.resolve("build"), settings, killing).run();

      TestResult result = ((Completed) outcome).result();
      assertThat(result.summary().pass()).as(killing.logText()).isEqualTo(55);
      assertThat(killing.logText()).contains("the simulator ended", "continuing with a new one");
    }
  }

  @Test
  void reportsARejectedWorldBeforeTheCompilation() throws Exception {
    try (Simulator simulator =
        Simulator.started(RealBridge.command(), directory, SandboxMode.AUTO.open(), 1)) {
      BuildOutcome outcome =
          build(infrared(Map.of("world/ir.xml", "<mujoco><oops/></mujoco>")), simulator);

      CompilationFailed failed = (CompilationFailed) outcome;
      assertThat(failed.message()).contains("the simulator rejects the world", "oops");
      assertThat(failed.diagnostics().get(0).file()).isEqualTo("activity/world/ir.world.yaml");
      assertThat(recording.stages()).containsExactly(BuildStage.PREPARING);
    }
  }

  @Test
  void anActivityWithAWorldNeedsASimulator() throws Exception {
    BuildOutcome outcome = build(infrared(Map.of()), Simulator.none());

    assertThat(((InfrastructureFailed) outcome).message()).contains("--bridge-command");
  }

  private static List<ProcessHandle> bridges() {
    return ProcessHandle.current()
        .descendants()
        .filter(ProcessHandle::isAlive)
        .filter(handle -> handle.info().commandLine().orElse("").contains("--stop-with-stdin"))
        .toList();
  }
}
