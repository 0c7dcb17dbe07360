package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.Coverage.Line;
import org.sitaf.core.verdict.RelationCount;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** The cases of a build run a second time for each relation. */
@Tag("slow")
class RelationRunsTest {
  private static final String COMPONENT =
      """
      package demo;

      public class Component {
        public int echo(int value) {
          if (value == 102) {
            %s
          }
          return value;
        }
      }
      """;

  private static final int MARKED_LINE = 6;

  @TempDir private Path directory;

  private final Recording recording = new Recording();

  private TestResult result(EchoActivity activity) throws IOException {
    return ((Completed)
            new BuildRun(
                    activity.generated(),
                    directory.resolve("build"),
                    EchoActivity.settings(SandboxMode.AUTO.open()),
                    recording)
                .run())
        .result();
  }

  @Test
  void aBrokenRelationIsKnownWhenTheCaseEnds() throws Exception {
    TestResult result =
        result(
            EchoActivity.withComponent(COMPONENT.formatted("return 0;"))
                .relation("more", "Value + 100", "after.value == before.value + 100")
                .relation("same", "Value", "after.value == before.value"));

    assertThat(result.summary().total()).isEqualTo(5);
    assertThat(result.summary().fail()).isEqualTo(1);
    assertThat(RelationCount.of(result.cases()))
        .containsExactly(
            new RelationCount("more", 5, 1, 0, 0), new RelationCount("same", 5, 0, 0, 0));
    assertThat(result.cases().get(1).message())
        .contains("relation 'more' is broken: 0 == 102; first run: Value=2 gave 2")
        .contains("second run: Value=102 gave 0");
    assertThat(recording.cases()).isEqualTo(result.cases());
  }

  @Test
  void theCoverageIsThatOfTheCases() throws Exception {
    TestResult result =
        result(
            EchoActivity.withComponent(COMPONENT.formatted("return 0;"))
                .relation("more", "Value + 100", "after.value != before.value"));

    assertThat(result.allPassed()).isTrue();
    Coverage coverage = result.coverage();
    assertThat(coverage).isNotNull();
    assertThat(coverage.files().get(0).lines()).contains(new Line(MARKED_LINE, false, 0, 0));
  }

  @Test
  void aCrashOfASecondRunIsAnErrorOfItsCaseOnly() throws Exception {
    TestResult result =
        result(
            EchoActivity.withComponent(
                    COMPONENT.formatted("Runtime.getRuntime().halt(9); return 0;"))
                .relation("more", "Value + 100", "after.value == before.value + 100"));

    assertThat(result.cases())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.ERROR, Verdict.PASS, Verdict.PASS, Verdict.PASS);
    assertThat(result.cases().get(1).message()).contains("the second run failed: ");
    assertThat(result.cases().get(1).actual().get(0).literal()).isEqualTo("2");
  }
}
