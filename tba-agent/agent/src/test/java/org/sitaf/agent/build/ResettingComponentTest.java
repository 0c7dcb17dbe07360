package org.sitaf.agent.build;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.agent.build.BuildOutcome.Completed;
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
import org.sitaf.core.verdict.Verdict;

/**
 * A component that touches the wall and then resets the simulation of its own case, so that the
 * signals of the rest of the case show no contact.
 */
@Tag("slow")
@Timeout(300)
class ResettingComponentTest {
  private static final String COMPONENT = "component/org/sitaf/examples/approach/WallApproach.java";

  /** Calls the test application's own connection to the simulator, and approaches carefully. */
  private static final String RESET =
      """
          try {
            var simulator = hardware.getClass().getDeclaredField("simulator");
            simulator.setAccessible(true);
            Object wire = simulator.get(hardware);
            var owner = wire.getClass().getDeclaredField("this$0");
            owner.setAccessible(true);
            Object simulation = owner.get(wire);
            %s
          } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
          }
          while (ahead() - distance > CLOSE_ENOUGH) {
            base.drive(Math.min(FASTEST, GAIN * (ahead() - distance)), 0);
            hardware.sleep(PERIOD);
          }
      """;

  private static final String PREPARE =
      "simulation.getClass().getMethod(\"prepare\", java.util.Map.class, Duration.class)"
          + ".invoke(simulation, java.util.Map.of(), Duration.ofMillis(200));";

  @TempDir private Path directory;

  @ParameterizedTest
  @ValueSource(
      strings = {
        PREPARE,
        // Under another number, and then under its own again.
        "var begins = simulation.getClass().getMethod(\"caseBegins\", int.class);"
            + "begins.invoke(simulation, 4711);"
            + PREPARE
            + "begins.invoke(simulation, 1);"
            + PREPARE,
        // Keeps the signals itself, before the reset.
        "simulation.getClass().getMethod(\"keepSignals\", int.class).invoke(simulation, 1);"
            + PREPARE,
      })
  void aResetOfTheOwnSimulationIsAnError(String reset) throws Exception {
    try (Simulator simulator =
        Simulator.started(RealBridge.command(), directory, SandboxMode.AUTO.open(), 1)) {
      BuildOutcome outcome =
          new BuildRun(
                  application(RESET.formatted(reset)),
                  directory.resolve("build"),
                  new BuildSettings(
                      simulator, EchoActivity.toolchains(), SandboxMode.AUTO.open(), false, ""),
                  new Recording())
              .run();

      CaseResult result = ((Completed) outcome).result().cases().get(0);
      assertThat(result.verdict()).as(result.toString()).isEqualTo(Verdict.ERROR);
      assertThat(result.message())
          .contains("trajectory conditions cannot be evaluated", "component");
    }
  }

  /** One case of the example, whose component resets the simulation after it touched the wall. */
  private static TestApplication application(String reset) throws IOException {
    Path example = Path.of(System.getProperty("sitaf.examples", ""), "touchless-approach-faulty");
    assumeTrue(Files.isDirectory(example), "skipped: missing " + example);
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> paths = Files.walk(example)) {
      for (Path path : paths.filter(Files::isRegularFile).toList()) {
        files.put(example.relativize(path).toString(), Files.readAllBytes(path));
      }
    }
    String touched = "      base.drive(FASTEST, 0);\n      hardware.sleep(PERIOD);\n    }\n";
    String source = new String(files.get(COMPONENT), UTF_8);
    assertThat(source).contains(touched);
    files.put(COMPONENT, source.replace(touched, touched + reset).getBytes(UTF_8));
    Activity activity = Activity.read(FileTree.of(files));
    TestModel model = activity.model("Approach").orElseThrow();
    var suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    return InterfaceTestApplicationGenerator.generate(
        activity, model, suite.withCases(List.of(suite.cases().get(0))));
  }
}
