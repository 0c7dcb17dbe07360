import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.sitaf.agent.build.RecordingOrder;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.simulation.BuildSimulator;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.suite.TestSuite;

/**
 * Measures test applications against their targets: each language on its infrared example, with the
 * simulation in its own process. Absolute times are valid for an idle machine; the ratios
 * compare them with well-known operations in the same run.
 */
public final class HarnessBenchmark {
  private static final int FEW = 1_000;
  private static final int MANY = 21_000;

  /** The default number of recorded cases of the server. */
  private static final int RECORDED = 100;

  private static final int RECORDED_RUNS = 5;

  /** Allowed additional time for recordings by default. */
  private static final double RECORDING_SECONDS = 0.5;

  private static final int SEQUENCES = 3_000;
  private static final double STEPS_PER_SECOND = 10_000;

  private static final int RUNS = 3;
  private static final int CHANGES = 9;
  private static final int WARM_UP = 4;
  private static final long PAUSE_MS = 2_000;

  /** The targets of a language. */
  private record Targets(
      String example, double overheadMicros, double casesPerSecond, double emptyMicros, double changeSeconds) {}

  private static final Map<Language, Targets> TARGETS =
      Map.of(
          Language.JAVA, new Targets("ir-sensor", 100, 20_000, 1, 1.5),
          Language.CPP, new Targets("ir-sensor-cpp", 100, 20_000, 1, 6),
          Language.PYTHON, new Targets("ir-sensor-python", 300, 5_000, Double.NaN, 1));

  private final Path home = Path.of(System.getProperty("sitaf.home"));
  private final Rows rows = new Rows();
  private double bareMicros;
  private double lineMicros;
  private double clockMicros;

  /** Arguments: languages, {@code recording} and {@code steps}; all are measured by default. */
  public static void main(String[] arguments) throws Exception {
    System.exit(new HarnessBenchmark().measure(List.of(arguments)) ? 0 : 1);
  }

  /**
   * The overhead of recordings for a case and for a build with the default number of recorded
   * cases, from a changed source: without motion, and with a robot that drives for
   * seconds. Builds with and without recordings alternate.
   */
  private void measureRecordings(Builds builds) throws Exception {
    measureRecordings("ir-sensor", LongSuite.withDistinctDistances(RECORDED), builds);
    measureRecordings("wall-approach", UnaryOperator.identity(), builds);
  }

  private void measureRecordings(String example, UnaryOperator<TestSuite> cases, Builds builds)
      throws Exception {
    Path folder = home.resolve("examples").resolve(example);
    List<Builds.Run> plain = new ArrayList<>();
    List<Builds.Run> recorded = new ArrayList<>();
    builds.run(folder, UnaryOperator.identity(), "");
    for (int i = 0; i < RECORDED_RUNS; i++) {
      plain.add(builds.run(folder, cases, changed(i), null));
      recorded.add(builds.run(folder, cases, changed(i), RecordingOrder.Cases.ALL));
    }
    double micros = median(plain, run -> run.casesMicros() / run.cases());
    double more = median(recorded, run -> run.casesMicros() / run.cases());
    rows.row(
        example + ": overhead of a recording per case",
        more - micros, "us", Double.NaN, false,
        more / micros, String.format(Locale.ROOT, "a case without recording (%.0f us)", micros));
    double seconds = median(plain, Builds.Run::seconds);
    double longer = median(recorded, Builds.Run::seconds);
    rows.row(
        example + ": overhead of recordings for a build of " + plain.get(0).cases() + " cases",
        longer - seconds, "s", RECORDING_SECONDS, false,
        longer / seconds, String.format(Locale.ROOT, "the build without recordings (%.2f s)", seconds));
  }

  /** Sequences of calls of a component that only reads its sensors. */
  private void measureSteps(Language language, boolean hasTarget, Builds builds) throws Exception {
    if (builds.toolchains().of(language).isEmpty()) {
      return;
    }
    Path activity =
        SensorSequences.write(
            home.resolve("examples").resolve(TARGETS.get(language).example()),
            builds.directory().resolve("sequences-" + language.id()));
    builds.run(activity, UnaryOperator.identity(), "");
    Builds.Run run = median(activity, LongSuite.repeated(SEQUENCES), builds);
    double perStep = run.casesMicros() / run.steps();
    rows.row(
        language.id() + ": steps of sequences, end to end",
        1e6 / perStep, "steps/s", hasTarget ? STEPS_PER_SECOND : Double.NaN, true,
        perStep / lineMicros, "writing its line");
  }

  private static String changed(int i) {
    return "change " + i + " of " + System.nanoTime();
  }

  private static double median(List<Builds.Run> runs, ToDoubleFunction<Builds.Run> of) {
    return runs.stream().mapToDouble(of).sorted().skip(runs.size() / 2).findFirst().orElseThrow();
  }

  private boolean measure(List<String> languages) throws Exception {
    Path state = home.resolve(".sitaf");
    Path directory = Files.createTempDirectory("sitaf-bench-");
    // Kept between runs, because a warm agent has its runtimes and environments.
    Toolchains toolchains =
        new Toolchains(new ToolchainPlaces(state.resolve("dist/agent"), state.resolve("bench")));
    List<String> bridge = List.of(state.resolve("venv/bin/python").toString(), "-m", "sitaf_bridge");
    Sandbox sandbox = SandboxMode.AUTO.open();
    try (Simulator simulator =
        Simulator.started(bridge, directory.resolve("simulator"), sandbox, Simulator.UNLIMITED)) {
      Builds builds = new Builds(simulator, toolchains, sandbox, directory);
      System.out.printf(
          Locale.ROOT,
          "%s; %d processors with a load of %.1f%n",
          sandbox.description(),
          Runtime.getRuntime().availableProcessors(),
          ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
      try (BuildSimulator alone = simulator.forBuild()) {
        bareMicros =
            BareSimulation.microsPerCase(
                alone.target(), home.resolve("examples/ir-sensor/world/ir.world.yaml"));
      }
      lineMicros = Alternatives.lineMicros(directory);
      clockMicros = Alternatives.clockMicros();
      rows.print("simulation only, in bulk, per case", bareMicros, "us");
      rows.print("writing a line only", lineMicros, "us");
      rows.print("reading the clock twice", clockMicros, "us");
      if (languages.isEmpty() || languages.contains("recording")) {
        measureRecordings(builds);
      }
      if (languages.isEmpty() || languages.contains("steps")) {
        measureSteps(Language.JAVA, true, builds);
        measureSteps(Language.CPP, true, builds);
        measureSteps(Language.PYTHON, false, builds);
      }
      for (Language language : Language.values()) {
        Path example = home.resolve("examples").resolve(TARGETS.get(language).example());
        if (!languages.isEmpty() && !languages.contains(language.id())) {
          continue;
        }
        if (toolchains.of(language).isEmpty()) {
          System.out.println(language.id() + ": skipped: " + toolchains.missingMessage(language));
        } else {
          measure(language, example, builds);
        }
      }
    } finally {
      toolchains.stop();
      try (Stream<Path> files = Files.walk(directory)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
    return rows.end("harness");
  }

  private void measure(Language language, Path example, Builds builds) throws Exception {
    Targets targets = TARGETS.get(language);
    String name = language.id();
    builds.run(example, UnaryOperator.identity(), "");
    // The baseline prepares each case, so every case must be prepared here, too.
    Builds.Run few = median(example, LongSuite.withDistinctDistances(FEW), builds);
    double overhead = few.casesMicros() / few.cases() - bareMicros - few.medianComponentMicros();
    rows.row(
        name + ": overhead per case, 1,000 cases",
        overhead, "us", targets.overheadMicros(), false,
        overhead / lineMicros, "writing its line");
    if (overhead < 0) {
      rows.fail(name + ": negative overhead: the baseline was slower than the measured cases");
    }
    endToEnd(name + ": end to end, 21,000 distances", LongSuite.withDistinctDistances(MANY), example, targets, builds);
    endToEnd(name + ": end to end, cases of the example repeated", LongSuite.repeated(MANY), example, targets, builds);

    Path empty = EmptyComponent.write(language, builds.directory().resolve("empty-" + name));
    double call = builds.run(empty, LongSuite.repeated(FEW), "").medianComponentMicros();
    rows.row(
        name + ": processing time of an empty component",
        call, "us", targets.emptyMicros(), false,
        call / clockMicros, "reading the clock twice");

    double compiler =
        Alternatives.compilerSeconds(
            language, example, home.resolve(".sitaf/dist/agent"), builds.directory());
    changes(name + ": changed source to first case", example, builds, PAUSE_MS, targets, compiler);
    changes(name + ": changed source to first case, without pause", example, builds, 0, targets, compiler);
  }

  /** Users pause between two changes, so the agent has prepared the next build; a queue does not pause. */
  private void changes(String what, Path example, Builds builds, long pauseMs, Targets targets, double compiler)
      throws Exception {
    List<Double> seconds = new ArrayList<>();
    for (int i = 0; i < WARM_UP + CHANGES; i++) {
      Thread.sleep(pauseMs);
      double second = builds.run(example, UnaryOperator.identity(), changed(i)).firstCaseSeconds();
      if (i >= WARM_UP) {
        seconds.add(second);
      }
    }
    seconds.sort(null);
    double change = seconds.get(CHANGES / 2);
    rows.row(
        what,
        change, "s", targets.changeSeconds(), false,
        change / compiler, String.format(Locale.ROOT, "compiling the component (%.2f s)", compiler));
  }

  private void endToEnd(
      String what, UnaryOperator<TestSuite> suite, Path example, Targets targets, Builds builds) throws Exception {
    Builds.Run run = median(example, suite, builds);
    double perCase = run.casesMicros() / run.cases();
    rows.row(
        what,
        1e6 / perCase, "cases/s", targets.casesPerSecond(), true,
        perCase / bareMicros, "the time of the simulation");
  }

  private static Builds.Run median(Path example, UnaryOperator<TestSuite> suite, Builds builds) throws Exception {
    List<Builds.Run> runs = new ArrayList<>();
    for (int i = 0; i < RUNS; i++) {
      runs.add(builds.run(example, suite, ""));
    }
    runs.sort(Comparator.comparing(Builds.Run::casesMicros));
    return runs.get(RUNS / 2);
  }
}
