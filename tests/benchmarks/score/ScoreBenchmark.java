import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.score.FaultExecutions;
import org.sitaf.core.score.FaultJudge;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.Verdict;

/**
 * Measures how long the score of the paper's evaluation takes, and whether the score orders weakened
 * specifications as mutations of the component's source do.
 */
public final class ScoreBenchmark {
  private static final String MODEL = "GetInfraredData.xml";
  private static final String SOURCE = "component/org/sitaf/examples/ir/InfraredSensor.java";
  private static final int BUDGET = 1_000;
  private static final int RUNS = 3;
  private static final long SEED = 17;

  private final Path home = Path.of(System.getProperty("sitaf.home"));
  private final Path example = home.resolve("examples/ir-sensor");
  private final Rows rows = new Rows();

  /** A specification with its suite. */
  private record Specification(String name, TestModel model, TestSuite suite) {}

  /** Argument: the number of mutations; 100 without one. With {@code --no-time} the time is not judged. */
  public static void main(String[] arguments) throws Exception {
    List<String> given = List.of(arguments);
    int mutations = given.stream().filter(a -> !a.startsWith("-")).map(Integer::parseInt).findFirst().orElse(100);
    System.exit(new ScoreBenchmark().measure(mutations, !given.contains("--no-time")) ? 0 : 1);
  }

  private boolean measure(int mutations, boolean timed) throws Exception {
    if (timed) {
      time();
    }
    Map<String, byte[]> files = files(example);
    List<Specification> specifications = new ArrayList<>();
    Map<String, String> models = Specifications.of(text(files.get(MODEL)));
    for (Map.Entry<String, String> each : models.entrySet()) {
      TestModel model = activity(files, MODEL, each.getValue()).models().get(0);
      specifications.add(
          new Specification(
              each.getKey(), model, TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite()));
    }
    try (LocalBuilds builds =
        new LocalBuilds(
            Installation.current(),
            SandboxMode.AUTO.open(),
            false,
            new LocalBuilds.OutputFolders(null, null, false),
            specifications.size() + 4 * mutations)) {
      double[] scores = scores(builds, files, models, specifications);
      int[] noticed = new int[specifications.size()];
      int done = mutate(builds, files, specifications, mutations, noticed);
      System.out.printf(Locale.ROOT, "%-40s %8s %8s%n", "specification", "score", "mutants");
      for (int i = 0; i < scores.length; i++) {
        System.out.printf(
            Locale.ROOT,
            "%-40s %7.1f%% %7.1f%%%n",
            specifications.get(i).name(),
            100 * scores[i],
            100.0 * noticed[i] / done);
      }
      rows.row(
          "Kendall's tau of " + scores.length + " specifications, " + done + " mutations",
          tau(scores, noticed), "", 0.8, true, 1, "of at most 1");
    }
    return rows.end("score");
  }

  /** The command as a user calls it. */
  private void time() throws Exception {
    List<Double> seconds = new ArrayList<>();
    Path json = Files.createTempFile("score", ".json");
    for (int i = 0; i < RUNS; i++) {
      long began = System.nanoTime();
      int exit =
          new ProcessBuilder(
                  home.resolve("sitaf").toString(), "score", example.toString(), "--json", json.toString())
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start()
              .waitFor();
      seconds.add((System.nanoTime() - began) / 1e9);
      if (exit == 2) {
        throw new IllegalStateException("./sitaf score failed");
      }
    }
    double injected =
        Double.parseDouble(Files.readString(json).replaceFirst("(?s).*\"injected\"\\s*:\\s*(\\d+).*", "$1"));
    Files.delete(json);
    rows.row("faults of ir-sensor", injected, "", 200, true, injected / 55, "the cases");
    double median = seconds.stream().sorted().toList().get(RUNS / 2);
    rows.row("time of ./sitaf score ir-sensor", median, "s", 4, false, 1e3 * median / injected, "1 ms per fault");
  }

  private double[] scores(
      LocalBuilds builds,
      Map<String, byte[]> files,
      Map<String, String> models,
      List<Specification> specifications)
      throws Exception {
    double[] scores = new double[specifications.size()];
    for (int i = 0; i < scores.length; i++) {
      Specification each = specifications.get(i);
      Activity activity = activity(files, MODEL, models.get(each.name()));
      FaultExecutions executions =
          new FaultExecutions(each.model(), each.suite(), activity.world(), activity.recorded(), BUDGET);
      Map<Integer, CaseRecord> records =
          records(builds, activity, each.model(), executions.cases())
              .orElseThrow(() -> new IllegalStateException("the component does not compile"));
      SpecificationScore score =
          new FaultJudge(
                  executions, each.suite(), activity.recorded(), TrajectoryConditions.NONE, records, Map.of())
              .score();
      scores[i] = score.share();
    }
    return scores;
  }

  /** Executes each mutation once with the cases of all specifications; returns their number. */
  private int mutate(
      LocalBuilds builds,
      Map<String, byte[]> files,
      List<Specification> specifications,
      int count,
      int[] noticed)
      throws Exception {
    Activity original = Activity.read(FileTree.of(files));
    TestModel model = specifications.get(0).model();
    Set<List<String>> rowsOfAll = new LinkedHashSet<>();
    specifications.forEach(s -> s.suite().cases().forEach(c -> rowsOfAll.add(c.values())));
    List<List<String>> ordered = List.copyOf(rowsOfAll);
    List<TestCase> cases = new ArrayList<>();
    for (List<String> row : ordered) {
      cases.add(new TestCase(cases.size() + 1, true, row, List.of()));
    }
    TestSuite union = specifications.get(0).suite().withCases(cases);
    int done = 0;
    for (String mutant : Mutations.of(text(files.get(SOURCE)), SEED)) {
      if (done == count) {
        break;
      }
      Activity activity = activity(files, SOURCE, mutant);
      Optional<Map<Integer, CaseRecord>> records = records(builds, activity, model, union);
      if (records.isEmpty()) {
        continue;
      }
      done++;
      for (int i = 0; i < noticed.length; i++) {
        noticed[i] += isNoticed(specifications.get(i), original, ordered, records.get()) ? 1 : 0;
      }
    }
    return done;
  }

  private static boolean isNoticed(
      Specification specification,
      Activity activity,
      List<List<String>> rows,
      Map<Integer, CaseRecord> records) {
    ResultAssembler assembler =
        new ResultAssembler(specification.model(), specification.suite(), activity.recorded());
    for (TestCase testCase : specification.suite().cases()) {
      CaseRecord record = records.get(rows.indexOf(testCase.values()) + 1);
      if (record == null
          || assembler.judge(record.numbered(testCase.no())).verdict() != Verdict.PASS) {
        return true;
      }
    }
    return false;
  }

  /** The records of all cases; empty if the component does not compile. */
  private static Optional<Map<Integer, CaseRecord>> records(
      LocalBuilds builds, Activity activity, TestModel model, TestSuite suite) throws Exception {
    Map<Integer, CaseRecord> records = new ConcurrentHashMap<>();
    BuildOutcome outcome =
        builds.record(
            activity,
            model,
            suite,
            false,
            new LocalBuilds.CaseObserver() {
              @Override
              public void caseRecorded(CaseRecord record) {
                records.put(record.no(), record);
              }

              @Override
              public void caseFinished(CaseResult result) {}
            });
    if (outcome instanceof BuildOutcome.CompilationFailed) {
      return Optional.empty();
    }
    if (!(outcome instanceof BuildOutcome.Completed)) {
      throw new IllegalStateException(outcome.toString());
    }
    return Optional.of(records);
  }

  /** Kendall's tau-b, which accounts for equal ranks. */
  private static double tau(double[] scores, int[] noticed) {
    long concordant = 0;
    long discordant = 0;
    long differentScores = 0;
    long differentMutants = 0;
    for (int i = 0; i < scores.length; i++) {
      for (int j = 0; j < i; j++) {
        int one = Double.compare(scores[i], scores[j]);
        int other = Integer.compare(noticed[i], noticed[j]);
        concordant += one * other > 0 ? 1 : 0;
        discordant += one * other < 0 ? 1 : 0;
        differentScores += one != 0 ? 1 : 0;
        differentMutants += other != 0 ? 1 : 0;
      }
    }
    return (concordant - discordant) / Math.sqrt((double) differentScores * differentMutants);
  }

  private static Activity activity(Map<String, byte[]> files, String path, String content) {
    Map<String, byte[]> changed = new HashMap<>(files);
    changed.put(path, content.getBytes(StandardCharsets.UTF_8));
    return Activity.read(FileTree.of(changed));
  }

  private static Map<String, byte[]> files(Path folder) throws Exception {
    Map<String, byte[]> files = new LinkedHashMap<>();
    try (Stream<Path> paths = Files.walk(folder)) {
      for (Path file : paths.filter(Files::isRegularFile).sorted(Comparator.naturalOrder()).toList()) {
        files.put(folder.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
    return files;
  }

  private static String text(byte[] content) {
    return new String(content, StandardCharsets.UTF_8);
  }
}
