package org.sitaf.agent.build;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.simulation.RealBridge;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Simulators that end while a component uses them and hides the error. */
@Tag("slow")
@Timeout(300)
class EndingSimulatorTest {
  private static final String MEASURING = "now measuring";

  @TempDir private Path directory;

  /** An infrared sensor that waits in simulation time and returns 42 after a failure. */
  private enum Sensor {
    JAVA(
        "ir-sensor",
        "component/org/sitaf/examples/ir/InfraredSensor.java",
        "    double range =",
        """
            if (indexOfSensor == 4) {
              System.out.println("now measuring");
              try {
                for (int i = 0; i < 20; i++) {
                  hardware.sleep(java.time.Duration.ofMillis(2));
                  java.util.concurrent.locks.LockSupport.parkNanos(20_000_000);
                }
              } catch (RuntimeException e) {
                return 42;
              }
            }
        """),
    PYTHON(
        "ir-sensor-python",
        "component/infrared_sensor.py",
        "        distance =",
        """
                if index_of_sensor == 4:
                    print("now measuring", flush=True)
                    try:
                        for _ in range(20):
                            self._hardware.sleep(0.002)
                            __import__("time").sleep(0.02)
                    except Exception:
                        return 42.0
        """),
    CPP(
        "ir-sensor-cpp",
        "component/infrared_sensor.cpp",
        "  const double range =",
        """
          if (indexOfSensor == 4) {
            std::puts("now measuring");
            std::fflush(stdout);
            try {
              for (int i = 0; i < 20; ++i) {
                hardware_.sleep(std::chrono::milliseconds(2));
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
              }
            } catch (const std::exception&) {
              return 42;
            }
          }
        """);

    private final String example;
    private final String file;
    private final String place;
    private final String code;

    Sensor(String example, String file, String place, String code) {
      this.example = example;
      this.file = file;
      this.place = place;
      this.code = code;
    }

    TestApplication application() throws IOException {
      Path folder = Path.of(System.getProperty("sitaf.examples", ""), example);
      assumeTrue(Files.isDirectory(folder), "skipped: missing " + folder);
      Map<String, byte[]> files = new HashMap<>();
      try (Stream<Path> paths = Files.walk(folder)) {
        for (Path path : paths.filter(Files::isRegularFile).toList()) {
          files.put(folder.relativize(path).toString(), Files.readAllBytes(path));
        }
      }
      String source = new String(files.get(file), UTF_8);
      assertThat(source).contains(place);
      String includes =
          this == CPP ? "#include <chrono>\n#include <cstdio>\n#include <thread>\n" : "";
      files.put(file, (includes + source.replace(place, code + place)).getBytes(UTF_8));
      Activity activity = Activity.read(FileTree.of(files));
      TestModel model = activity.model("GetInfraredData").orElseThrow();
      return InterfaceTestApplicationGenerator.generate(
          activity, model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
    }
  }

  /** Kills the bridge the given number of times when the component measures. */
  private static final class Killing extends Recording {
    private final AtomicInteger left;

    Killing(int times) {
      left = new AtomicInteger(times);
    }

    @Override
    public void log(byte[] utf8) {
      super.log(utf8);
      if (new String(utf8, UTF_8).contains(MEASURING) && left.getAndDecrement() > 0) {
        ProcessHandle.current()
            .descendants()
            .filter(handle -> handle.info().commandLine().orElse("").contains("--endpoints"))
            .forEach(ProcessHandle::destroyForcibly);
      }
    }
  }

  private TestResult result(TestApplication application, Recording recording) throws Exception {
    try (Simulator simulator =
        Simulator.started(RealBridge.command(), directory, SandboxMode.AUTO.open(), 1)) {
      BuildSettings settings =
          new BuildSettings(
              simulator, EchoActivity.toolchains(), SandboxMode.AUTO.open(), false, "");
      BuildOutcome outcome =
          new BuildRun(application, directory.resolve("build"), settings, recording).run();
      assertThat(outcome).as(recording.logText()).isInstanceOf(Completed.class);
      return ((Completed) outcome).result();
    }
  }

  @ParameterizedTest
  @EnumSource
  void aSimulatorKilledWithinACallCostsNoCase(Sensor sensor) throws Exception {
    assumeTrue(
        EchoActivity.toolchains().of(Language.valueOf(sensor.name())).isPresent(),
        "skipped: toolchain not installed");
    Killing killing = new Killing(1);
    TestResult result = result(sensor.application(), killing);

    assertThat(result.summary().pass()).as(killing.logText()).isEqualTo(55);
    assertThat(killing.logText()).contains("the simulator ended", "continuing with a new one");
  }

  @Test
  void aCaseThatAlwaysCrashesItsSimulatorIsAnError() throws Exception {
    Killing killing = new Killing(1000);
    TestResult result = result(Sensor.JAVA.application(), killing);

    assertThat(result.summary().pass()).isLessThan(55);
    assertThat(result.summary().fail()).as(result.cases() + killing.logText()).isZero();
    assertThat(result.cases())
        .filteredOn(c -> c.verdict() == Verdict.ERROR)
        .extracting(CaseResult::message)
        .isNotEmpty()
        .allSatisfy(message -> assertThat(message).contains("each time in this case"));
    assertThat(result.cases().get(54).verdict()).isEqualTo(Verdict.DONT);
  }
}
