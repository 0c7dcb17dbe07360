package org.sitaf.agent.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.AnalysisReport.Explained;
import org.sitaf.agent.build.AnalysisReport.Repeated;
import org.sitaf.agent.build.AnalysisReport.Scored;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildOutcome.Analysed;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.flaky.FlakyCase;
import org.sitaf.core.flaky.FlakyCause;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.score.mutation.MutationScore;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Analyses of a component that fails with two of its five values. */
@Tag("slow")
class AnalysisRunTest {
  @TempDir private Path directory;

  private final Recording recording = new Recording();
  private final TestApplication application =
      EchoActivity.withBody("return value > 3 ? 0 : value;").generated();

  private TestResult executed() throws Exception {
    return ((Completed)
            new BuildRun(
                    application,
                    directory.resolve("build"),
                    EchoActivity.settings(SandboxMode.AUTO.open()),
                    new Recording())
                .run())
        .result();
  }

  private AnalysisRun analysis(AnalysisOrder order, Recording listener) throws Exception {
    return new AnalysisRun(
        application,
        order,
        directory.resolve("analysis"),
        EchoActivity.settings(SandboxMode.AUTO.open()),
        listener);
  }

  @Test
  void failuresAreExplainedWithFurtherCases() throws Exception {
    BuildOutcome outcome = analysis(new AnalysisOrder.Explain(executed(), 50), recording).run();

    Explained explained = (Explained) ((Analysed) outcome).report();
    assertThat(explained.explanation().unexplained()).isEmpty();
    assertThat(explained.explanation().causes())
        .extracting(Cause::parameters)
        .containsExactlyInAnyOrder(Map.of("Value", "4"), Map.of("Value", "5"));
    assertThat(explained.records()).allSatisfy(r -> assertThat(r).containsEntry("verdict", "FAIL"));
    assertThat(explained.inputs())
        .singleElement()
        .satisfies(input -> assertThat(input.values()).hasSize(5));
    assertThat(explained.further()).hasSize(explained.explanation().executions());
    assertThat(recording.cases())
        .extracting(CaseResult::no)
        .containsExactlyElementsOf(
            java.util.stream.IntStream.rangeClosed(1, explained.further().size()).boxed().toList());
    assertThat(Files.readString(directory.resolve("analysis").resolve(BuildRun.LOG)))
        .contains("[sitaf] case 1: ");
    try (var left = Files.list(directory.resolve("analysis"))) {
      assertThat(left.map(f -> f.getFileName().toString())).containsExactly(BuildRun.LOG);
    }
  }

  @Test
  void theSpecificationIsScored() throws Exception {
    BuildOutcome outcome = analysis(new AnalysisOrder.Score(50), recording).run();

    Scored scored = (Scored) ((Analysed) outcome).report();
    assertThat(scored.score().injected()).isPositive();
    assertThat(scored.score().noticed()).isPositive();
    MutationScore mutations = Objects.requireNonNull(scored.mutations());
    // Of `value > 3`: both other comparisons. Of `0` nothing, which is no returned value alone.
    assertThat(mutations.made())
        .isEqualTo(
            mutations.noticed() + mutations.unchanged().size() + mutations.survivors().size());
    assertThat(mutations.noticed()).isGreaterThanOrEqualTo(2);
    assertThat(recording.cases()).hasSizeGreaterThanOrEqualTo(5);
  }

  @Test
  void repeatedRunsFindTheCaseThatDiffers() throws Exception {
    TestApplication clock =
        EchoActivity.withBody("return value == 3 ? (int) System.nanoTime() : value;").generated();
    BuildOutcome outcome =
        new AnalysisRun(
                clock,
                new AnalysisOrder.Repeat(executed(), 17),
                directory.resolve("analysis"),
                EchoActivity.settings(SandboxMode.AUTO.open()),
                recording)
            .run();

    Repeated repeated = (Repeated) ((Analysed) outcome).report();
    assertThat(repeated.runs()).isEqualTo(3);
    assertThat(repeated.flaky()).extracting(FlakyCase::no).containsExactly(3, 4, 5);
    assertThat(repeated.flaky().get(0).line())
        .isEqualTo(
            "case 3: PASS FAIL FAIL FAIL; the component: its inputs are equal, and what it returns"
                + " differs");
    assertThat(repeated.flaky().get(1).cause()).isEqualTo(FlakyCause.UNKNOWN);
    assertThat(recording.cases())
        .extracting(CaseResult::no)
        .containsExactlyElementsOf(java.util.stream.IntStream.rangeClosed(1, 15).boxed().toList());
    assertThat(Files.readString(directory.resolve("analysis").resolve(BuildRun.LOG)))
        .contains("[sitaf] run 3 of 3: 1 of 5 cases did not pass");
  }

  @Test
  void aCancelledAnalysisEnds() throws Exception {
    TestResult executed = executed();
    AtomicReference<AnalysisRun> run = new AtomicReference<>();
    run.set(
        analysis(
            new AnalysisOrder.Explain(executed, 50),
            new Recording() {
              @Override
              public void caseFinished(CaseResult result) {
                super.caseFinished(result);
                run.get().cancel("not wanted");
              }
            }));

    assertThat(run.get().run()).isEqualTo(new BuildOutcome.Cancelled("not wanted"));
    assertThat(Thread.interrupted()).isFalse();
  }

  @Test
  void aResultWithoutFailuresHasNoCauses() throws Exception {
    TestResult passed =
        new TestResult(
            executed().name(),
            executed().provenance(),
            executed().summary(),
            executed().parameters(),
            executed().cases().stream().filter(c -> c.verdict() == Verdict.PASS).toList(),
            null,
            List.of());
    BuildOutcome outcome = analysis(new AnalysisOrder.Explain(passed, 50), recording).run();

    assertThat(((Explained) ((Analysed) outcome).report()).explanation().causes()).isEmpty();
    assertThat(recording.cases()).isEmpty();
  }
}
