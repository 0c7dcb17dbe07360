package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.Coverage.Line;
import org.sitaf.core.verdict.TestResult;

/** The result contains the line coverage of the component. */
@Tag("slow")
class CoverageTest {
  private static final String BRANCHING =
      """
      package demo;

      public class Component {
        public int echo(int value) {
          if (value > 3) {
            return value;
          }
          if (value > 99) {
            return -1;
          }
          %s
          return value;
        }
      }
      """;

  @TempDir private Path directory;

  private TestResult result(EchoActivity activity, boolean generated) throws IOException {
    return ((Completed)
            new BuildRun(
                    generated ? activity.generated() : activity.application(),
                    directory.resolve("build"),
                    EchoActivity.settings(SandboxMode.AUTO.open()),
                    new Recording())
                .run())
        .result();
  }

  @Test
  void reportsLinesAndBranchesByFile() throws Exception {
    TestResult result = result(EchoActivity.withComponent(BRANCHING.formatted("")), false);

    Coverage coverage = result.coverage();
    assertThat(coverage).isNotNull();
    assertThat(coverage.files()).hasSize(1);
    assertThat(coverage.files().get(0).path()).isEqualTo("component/demo/Component.java");
    assertThat(coverage.files().get(0).lines())
        .contains(
            new Line(5, true, 2, 2),
            new Line(6, true, 0, 0),
            new Line(8, true, 2, 1),
            new Line(9, false, 0, 0));
    assertThat(coverage.branch()).hasValue(75);
    assertThat(coverage.statement().orElseThrow()).isBetween(80.0, 90.0);
  }

  @Test
  void keepsCoverageBeforeAndAfterACrash() throws Exception {
    String crash = "if (value == 2) { Runtime.getRuntime().halt(9); }";
    TestResult result = result(EchoActivity.withComponent(BRANCHING.formatted(crash)), false);

    assertThat(result.summary().error()).isEqualTo(1);
    Coverage coverage = result.coverage();
    assertThat(coverage).isNotNull();
    assertThat(coverage.files().get(0).lines()).contains(new Line(6, true, 0, 0));
  }

  @Test
  void keepsCoverageOfAHangingCase() throws Exception {
    String hang = "if (value == 3) { while (true) { Thread.onSpinWait(); } }";
    TestResult result =
        result(
            EchoActivity.withComponent(BRANCHING.formatted(hang)).cases(3).caseWallSeconds(1),
            true);

    assertThat(result.summary().error()).isEqualTo(1);
    Coverage coverage = result.coverage();
    assertThat(coverage).isNotNull();
    assertThat(coverage.files().get(0).lines())
        .filteredOn(line -> line.number() == 11)
        .allSatisfy(line -> assertThat(line.reached()).isTrue())
        .hasSize(1);
  }

  @Test
  void reportsAFailedImportInsteadOfMissingCoverage() throws Exception {
    Toolchains toolchains = EchoActivity.toolchains();
    assumeTrue(
        toolchains.of(Language.PYTHON).isPresent(),
        () -> "skipped: " + toolchains.missingMessage(Language.PYTHON));
    TestResult result =
        result(
            EchoActivity.inPython("sensor.Sensor")
                .file(
                    "component/sensor.py",
                    """
                    import no_such_module

                    class Sensor:
                        def echo(self, value):
                            return value
                    """),
            true);

    assertThat(result.summary().dont()).isEqualTo(5);
    assertThat(result.cases().get(0).message())
        .contains("No module named 'no_such_module'")
        .doesNotContain("CoverageWarning", "No data was collected");
  }
}
