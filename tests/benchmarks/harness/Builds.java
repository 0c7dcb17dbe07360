import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.build.RecordingOrder;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;

/** Whole builds of activities, as an agent runs them. */
record Builds(Simulator simulator, Toolchains toolchains, Sandbox sandbox, Path directory) {
  /** The limits of the server. */
  private static final int MAX_RECORDINGS = 500;

  private static final long MAX_BYTES = 64 << 20;

  /**
   * The times of a build.
   *
   * @param steps number of steps if the cases are sequences
   * @param firstCaseSeconds time from the activity's files to the first result
   * @param casesMicros time from the first result to the last
   */
  record Run(int cases, int steps, double firstCaseSeconds, double casesMicros, double medianComponentMicros) {
    /** Time from the activity's files to the last result. */
    double seconds() {
      return firstCaseSeconds + casesMicros / 1e6;
    }
  }

  /**
   * Runs the cases of an activity's first model.
   *
   * @param lengthened converts the suite of the model to the suite to run
   * @param change a comment that is added to each source of the component; empty for none
   */
  Run run(Path activityFolder, UnaryOperator<TestSuite> lengthened, String change) throws Exception {
    return run(activityFolder, lengthened, change, null);
  }

  /** Runs the cases and records some of them; null for none. */
  Run run(
      Path activityFolder,
      UnaryOperator<TestSuite> lengthened,
      String change,
      RecordingOrder.@Nullable Cases recorded)
      throws Exception {
    long began = System.nanoTime();
    Activity activity = Activity.read(files(activityFolder, change));
    TestModel model = activity.models().get(0);
    TestSuite suite =
        lengthened.apply(TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
    List<Long> ends = new ArrayList<>();
    BuildSettings settings = new BuildSettings(simulator, toolchains, sandbox, false, "benchmark");
    Path folder = Files.createTempDirectory(directory, "build");
    if (recorded != null) {
      settings =
          settings.recording(
              new RecordingOrder(folder.resolve("kept"), recorded, MAX_RECORDINGS, MAX_BYTES));
    }
    BuildOutcome outcome =
        new BuildRun(
                InterfaceTestApplicationGenerator.generate(activity, model, suite),
                folder,
                settings,
                new BuildListener() {
                  @Override
                  public void stage(BuildStage stage) {}

                  @Override
                  public void log(byte[] utf8) {}

                  @Override
                  public void caseFinished(CaseResult result) {
                    ends.add(System.nanoTime());
                  }

                  @Override
                  public void recorded(int no, Path recording) {}
                })
            .run();
    // Like an agent after each build.
    toolchains.startAhead(activity.profile().harness(), sandbox);
    if (!(outcome instanceof BuildOutcome.Completed completed)) {
      throw new IllegalStateException(activityFolder + ": " + outcome);
    }
    TestResult result = completed.result();
    if (result.summary().pass() != suite.cases().size()) {
      throw new IllegalStateException(activityFolder + ": not every case passed: " + result.summary());
    }
    List<Double> component =
        result.cases().stream().map(c -> c.time() == null ? 0 : c.time().total()).sorted().toList();
    return new Run(
        suite.cases().size(),
        suite.cases().stream().mapToInt(c -> c.steps().size()).sum(),
        (ends.get(0) - began) / 1e9,
        (ends.get(ends.size() - 1) - ends.get(0)) / 1e3,
        component.get(component.size() / 2));
  }

  private static FileTree files(Path folder, String change) throws Exception {
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> paths = Files.walk(folder)) {
      for (Path file : paths.filter(Files::isRegularFile).toList()) {
        String path = folder.relativize(file).toString();
        byte[] content = Files.readAllBytes(file);
        if (!change.isEmpty() && path.startsWith("component/")) {
          content = changed(path, content, change);
        }
        files.put(path, content);
      }
    }
    return FileTree.of(files);
  }

  private static byte[] changed(String path, byte[] content, String change) {
    String mark = path.endsWith(".py") ? "# " : "// ";
    return path.matches(".*\\.(java|cpp|hpp|h|py)")
        ? (new String(content, StandardCharsets.UTF_8) + "\n" + mark + change + "\n")
            .getBytes(StandardCharsets.UTF_8)
        : content;
  }
}
