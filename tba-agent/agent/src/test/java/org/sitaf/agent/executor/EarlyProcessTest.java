package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.compiler.TestApplicationCompiler;
import org.sitaf.agent.sandbox.ProcessGroup;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.Verdict;

/** A process that starts before its application is compiled. */
@Tag("slow")
@Timeout(300)
class EarlyProcessTest {
  private static final String REMEMBER_PROCESS =
      "System.out.println(\"in \" + ProcessHandle.current().info().startInstant().get());";

  @TempDir private Path directory;
  private final List<String> log = new ArrayList<>();

  private final OutputSink sink =
      new OutputSink() {
        @Override
        public void output(String text, int caseNo) {
          synchronized (log) {
            log.addAll(text.lines().toList());
          }
        }

        @Override
        public void remark(String line) {
          output("[sitaf] " + line, 0);
        }
      };

  /** Starts the process early, compiles, and executes. */
  private Execution execute(EchoActivity activity, Sandbox sandbox) throws Exception {
    TestApplication application = activity.application();
    Path files = directory.resolve("application");
    for (String path : application.files().paths()) {
      Path file = files.resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, application.files().content(path).orElseThrow());
    }
    Toolchain toolchain = EchoActivity.toolchains().of(Language.JAVA).orElseThrow();
    TestApplicationCompiler compiler =
        new TestApplicationCompiler(toolchain, directory.resolve("cache"), false, sandbox);
    Compilation compilation = compiler.begin(application, files, directory.resolve("compilation"));
    ExecutionRequest early =
        request(toolchain.openEarly(compilation).orElseThrow(), application, files, sandbox);
    try (EarlyProcess waiting = EarlyProcess.start(early, sink)) {
      Thread.sleep(Duration.ofSeconds(2).toMillis());
      assertThat(classesIn(compilation.output())).isEmpty();
      CompiledApplication compiled = compiler.compile(compilation);
      assertThat(classesIn(compilation.output())).isNotEmpty();
      return TestApplicationExecutor.DEFAULT.execute(
          request(compiled, application, files, sandbox),
          waiting,
          sink,
          new ResultAssembler(application.model(), application.suite())::judge);
    }
  }

  private ExecutionRequest request(
      CompiledApplication compiled, TestApplication application, Path files, Sandbox sandbox)
      throws IOException {
    Path execution = Files.createDirectories(directory.resolve("execution"));
    return new ExecutionRequest(
        compiled,
        sandbox,
        files,
        application.suite(),
        files.resolve("suite.xml"),
        execution,
        execution.resolve("coverage"),
        null,
        null,
        null,
        application.activity().profile().limits(),
        0);
  }

  private static List<Path> classesIn(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(file -> file.toString().endsWith(".class")).toList();
    }
  }

  private long processes() {
    return log.stream().filter(line -> line.startsWith("in ")).distinct().count();
  }

  @Test
  void runsEveryCaseWithClassesThatWereCompiledLater() throws Exception {
    Execution execution =
        execute(EchoActivity.withBody(REMEMBER_PROCESS + "return value;"), SandboxMode.AUTO.open());

    assertThat(execution.results())
        .describedAs(log.toString())
        .extracting(CaseResult::verdict)
        .containsOnly(Verdict.PASS)
        .hasSize(5);
    assertThat(processes()).isEqualTo(1);
  }

  @Test
  void standardInputOfTheComponentIsEmpty() throws Exception {
    Execution execution =
        execute(
            EchoActivity.withBody("return System.in.read() == -1 ? value : -value;"),
            Sandbox.none());

    assertThat(execution.results()).extracting(CaseResult::verdict).containsOnly(Verdict.PASS);
  }

  @Test
  void casesAfterACrashRunInANewProcess() throws Exception {
    Execution execution =
        execute(
            EchoActivity.withBody(
                REMEMBER_PROCESS
                    + "if (value == 3) Runtime.getRuntime().halt(9);"
                    + "return value;"),
            SandboxMode.AUTO.open());

    assertThat(execution.results())
        .extracting(CaseResult::verdict)
        .containsExactly(Verdict.PASS, Verdict.PASS, Verdict.ERROR, Verdict.PASS, Verdict.PASS);
    assertThat(execution.results().get(2).message()).contains("exit code 9");
    assertThat(processes()).isEqualTo(2);
  }

  @Test
  void aFailedCompilationEndsTheProcess() throws Exception {
    Path build = directory.resolve("build");
    BuildOutcome outcome =
        new BuildRun(
                EchoActivity.withBody("return value +;").application(),
                build,
                EchoActivity.settings(SandboxMode.AUTO.open()),
                new Recording())
            .run();

    assertThat(outcome).isInstanceOf(BuildOutcome.CompilationFailed.class);
    String mark = "SITAF_RUN=" + ProcessGroup.markOf(build);
    assertThat(environments()).noneMatch(environment -> environment.contains(mark));
  }

  private static List<String> environments() throws IOException {
    List<String> environments = new ArrayList<>();
    try (var processes = Files.newDirectoryStream(Path.of("/proc"), "[0-9]*")) {
      for (Path process : processes) {
        try {
          environments.add(Files.readString(process.resolve("environ")));
        } catch (IOException e) {
          // The process has ended or belongs to another user.
        }
      }
    }
    return environments;
  }
}
