package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.CompilationFailed;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.build.BuildOutcome.InfrastructureFailed;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** A build without any server, with a real compiler and real processes. */
@Tag("slow")
class BuildRunTest {
  @TempDir private Path directory;
  private final Recording recording = new Recording();

  private BuildOutcome build(EchoActivity activity) {
    return new BuildRun(
            activity.application(), directory.resolve("build"), EchoActivity.settings(), recording)
        .run();
  }

  @Test
  void aCorrectComponentPassesEveryCase() throws Exception {
    BuildOutcome outcome =
        build(EchoActivity.withBody("System.out.println(\"echo \" + value); return value;"));

    TestResult result = ((Completed) outcome).result();
    assertThat(result.summary().total()).isEqualTo(5);
    assertThat(result.summary().pass()).isEqualTo(5);
    assertThat(result.name()).isEqualTo("Echo");
    assertThat(recording.stages())
        .containsExactly(BuildStage.PREPARING, BuildStage.COMPILING, BuildStage.RUNNING);
    assertThat(recording.cases()).extracting(c -> c.no()).containsExactly(1, 2, 3, 4, 5);
    assertThat(recording.logText()).contains("echo 1\n", "echo 5\n");
    assertThat(directory.resolve("build").resolve(BuildRun.LOG)).hasContent(recording.logText());
  }

  @Test
  void recordsTheProvenance() throws Exception {
    var first = ((Completed) build(EchoActivity.withBody("return value;"))).result().provenance();
    var other = ((Completed) build(EchoActivity.withBody("return +value;"))).result().provenance();

    assertThat(first.agent()).isEqualTo("tester 1");
    assertThat(first.bridge()).isEmpty();
    assertThat(first.suite()).matches("[0-9a-f]{64}").isEqualTo(other.suite());
    assertThat(first.harness()).matches("[0-9a-f]{64}").isEqualTo(other.harness());
    assertThat(first.component()).matches("[0-9a-f]{64}").isNotEqualTo(other.component());
    assertThat(first.started()).isLessThanOrEqualTo(first.finished());
  }

  @Test
  void aWrongValueFailsOnlyItsCase() {
    BuildOutcome outcome = build(EchoActivity.withBody("return value == 3 ? 4 : value;"));

    TestResult result = ((Completed) outcome).result();
    assertThat(result.cases())
        .extracting(c -> c.verdict())
        .containsExactly(Verdict.PASS, Verdict.PASS, Verdict.FAIL, Verdict.PASS, Verdict.PASS);
  }

  @Test
  void reportsASyntaxErrorWithFileLineAndColumn() {
    BuildOutcome outcome =
        build(
            EchoActivity.withComponent(
                "package demo;\n"
                    + "public class Component {\n"
                    + "  int echo(int value) { return value }\n"
                    + "}\n"));

    CompilationFailed failed = (CompilationFailed) outcome;
    SourceDiagnostic diagnostic = failed.diagnostics().get(0);
    assertThat(diagnostic.file()).isEqualTo("activity/component/demo/Component.java");
    assertThat(diagnostic.line()).isEqualTo(3);
    assertThat(diagnostic.column()).isEqualTo(37);
    assertThat(diagnostic.message()).isEqualTo("';' expected");
    assertThat(diagnostic.generated()).isFalse();
    assertThat(failed.message()).contains("1 error", "Component.java:3:37");
    assertThat(recording.logText()).contains("Component.java:3:37: error: ';' expected");
  }

  @Test
  void aComponentWithAWrongInterfaceIsAnErrorInTheGeneratedFile() {
    BuildOutcome outcome =
        build(
            EchoActivity.withComponent(
                "package demo; public class Component { public String echo() { return \"\"; } }"));

    CompilationFailed failed = (CompilationFailed) outcome;
    assertThat(failed.message()).contains("does not fit the generated test application");
    assertThat(failed.diagnostics())
        .isNotEmpty()
        .allSatisfy(
            d -> {
              assertThat(d.generated()).isTrue();
              assertThat(d.file()).isEqualTo("harness/sitaf/harness/echo/ScriptedHarness.java");
            });
  }

  @Test
  void reportsAMissingClassWithTheExistingOnes() {
    BuildOutcome outcome = build(EchoActivity.withComponent("package demo; public class Other {}"));

    CompilationFailed failed = (CompilationFailed) outcome;
    assertThat(failed.message()).isEqualTo("there is no class demo.Component");
    assertThat(failed.diagnostics().get(0).file()).isEqualTo("activity/activity.yaml");
    assertThat(failed.diagnostics().get(0).message()).contains("the sources define demo.Other");
  }

  @Test
  void doesNotRunAnnotationProcessorsOfUsers() {
    String processor =
        """
        package demo;
        import java.util.Set;
        import javax.annotation.processing.*;
        import javax.lang.model.element.TypeElement;
        @SupportedAnnotationTypes("*")
        public class Processor extends AbstractProcessor {
          static { if (true) throw new Error("ran"); }
          public boolean process(Set<? extends TypeElement> a, RoundEnvironment r) { return false; }
        }
        """;
    BuildOutcome outcome =
        build(
            EchoActivity.withBody("return value;")
                .file("component/demo/Processor.java", processor)
                .file(
                    "component/META-INF/services/javax.annotation.processing.Processor",
                    "demo.Processor\n"));

    assertThat(outcome).isInstanceOf(Completed.class);
  }

  @Test
  void reportsAMissingToolchainWithItsRemedy() {
    BuildSettings settings =
        new BuildSettings(
            Simulator.none(),
            new Toolchains(
                new ToolchainPlaces(directory.resolve("runtimes"), directory.resolve("cache"))),
            Sandbox.none(),
            false,
            "");
    BuildOutcome outcome =
        new BuildRun(
                EchoActivity.withBody("return value;").application(),
                directory.resolve("build"),
                settings,
                recording)
            .run();

    assertThat(((InfrastructureFailed) outcome).message())
        .startsWith("no toolchain for java (")
        .contains("does not hold the runtime", "; install the agent with", "this agent offers ");
  }

  @Test
  void filesNextToTheSourcesAreResources() {
    BuildOutcome outcome =
        build(
            EchoActivity.withBody(
                    """
                    try (var in = Component.class.getResourceAsStream("offset.txt")) {
                      return value + Integer.parseInt(new String(in.readAllBytes()).strip());
                    }\
                    """)
                .file("component/demo/offset.txt", "0\n"));

    assertThat(((Completed) outcome).result().summary().pass()).isEqualTo(5);
  }

  @Test
  void cancellationStopsTheEvaluationOfPostConditions() {
    String digits = "[0,1,2,3,4,5,6,7,8,9]";
    String slow =
        digits + ".all(a, " + digits + ".all(b, " + digits + ".all(c, a + b + c + actual != 0)))";
    EchoActivity activity = EchoActivity.withBody("return value;").cases(400);
    for (int i = 0; i < 20; i++) {
      activity.postCondition(slow);
    }
    AtomicReference<BuildRun> run = new AtomicReference<>();
    Recording cancelling =
        new Recording() {
          @Override
          public void caseFinished(CaseResult result) {
            super.caseFinished(result);
            run.get().cancel("not wanted");
          }
        };
    run.set(
        new BuildRun(
            activity.application(),
            directory.resolve("build"),
            EchoActivity.settings(),
            cancelling));

    assertThat(run.get().run()).isEqualTo(new BuildOutcome.Cancelled("not wanted"));
    assertThat(cancelling.cases()).as("no further case is evaluated").hasSize(1);
  }

  @Test
  void anExpensivePostConditionIsAnErrorOfItsCase() {
    String digits = "[0,1,2,3,4,5,6,7,8,9]";
    EchoActivity activity =
        EchoActivity.withBody("return value;")
            .cases(2)
            .postCondition("actual != 1 || ['ab']" + ".map(s, s + s)".repeat(30) + "[0] == ''")
            .postCondition(digits + ".all(a, a != actual + 20)");

    TestResult result = ((Completed) build(activity)).result();
    assertThat(result.cases())
        .extracting(c -> c.verdict())
        .containsExactly(Verdict.ERROR, Verdict.PASS);
    assertThat(result.cases().get(0).message()).contains("it creates a string of", "1,000,000");
  }

  @Test
  void aBuildCancelledBeforeItsStartDoesNothing() {
    BuildRun run =
        new BuildRun(
            EchoActivity.withBody("return value;").application(),
            directory.resolve("build"),
            EchoActivity.settings(),
            recording);
    run.cancel("not wanted");

    assertThat(run.run()).isEqualTo(new BuildOutcome.Cancelled("not wanted"));
    assertThat(recording.stages()).isEmpty();
    assertThat(Files.exists(directory.resolve("build/classes"))).isFalse();
  }
}
