import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * Steps per second of sequences, end to end: the infrared sensor that is enabled, read and disabled,
 * whose calls take no simulation time. From the first result to the last, judged.
 */
public final class StepRate {
  private static final int STEPS = 120_000;
  private static final int RUNS = 3;
  private static final double TARGET = 10_000;

  private static final Map<Language, String> COMPONENTS =
      Map.of(
          Language.JAVA, "ir-sensor-states",
          Language.CPP, "ir-sensor-cpp",
          Language.PYTHON, "ir-sensor-python");

  private final Path home = Path.of(System.getProperty("sitaf.home"));
  private final Rows rows = new Rows();

  public static void main(String[] arguments) throws Exception {
    System.exit(new StepRate().measure() ? 0 : 1);
  }

  private boolean measure() throws Exception {
    Path state = home.resolve(".sitaf");
    Path directory = Files.createTempDirectory("sitaf-bench-");
    Toolchains toolchains =
        new Toolchains(new ToolchainPlaces(state.resolve("dist/agent"), state.resolve("bench")));
    List<String> bridge =
        List.of(state.resolve("venv/bin/python").toString(), "-m", "sitaf_bridge");
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
      for (Language language : Language.values()) {
        if (toolchains.of(language).isEmpty()) {
          System.out.println(language.id() + ": skipped: " + toolchains.missingMessage(language));
        } else {
          measure(language, builds);
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
    return rows.end("steps");
  }

  private void measure(Language language, Builds builds) throws Exception {
    boolean hasTarget = language != Language.PYTHON;
    double single = perStep(singleCalls(language, builds), builds);
    for (boolean events : new boolean[] {false, true}) {
      Path activity = activity(language, events, builds.directory());
      double micros = perStep(activity, builds);
      rows.row(
          language.id() + ": steps end to end, " + (events ? "calls and events" : "calls"),
          1e6 / micros,
          "steps/s",
          hasTarget ? TARGET : Double.NaN,
          true,
          micros / single,
          String.format(Locale.ROOT, "a case of one call (%.0f us)", single));
    }
  }

  /** The median time of a step, or of a case of one call, in microseconds. */
  private double perStep(Path activity, Builds builds) throws Exception {
    builds.run(activity, UnaryOperator.identity(), "");
    List<Double> micros = new ArrayList<>();
    for (int i = 0; i < RUNS; i++) {
      int[] steps = {0};
      Builds.Run run =
          builds.run(
              activity,
              suite -> {
                TestSuite longer = repeated(suite);
                steps[0] = longer.cases().stream().mapToInt(StepRate::steps).sum();
                return longer;
              },
              "");
      micros.add(run.casesMicros() / steps[0]);
    }
    micros.sort(null);
    return micros.get(RUNS / 2);
  }

  private static int steps(TestCase testCase) {
    return Math.max(1, testCase.steps().size());
  }

  /** Repeats the cases up to the number of steps; of single calls, a tenth of it. */
  private static TestSuite repeated(TestSuite suite) {
    List<TestCase> cases = new ArrayList<>();
    int most = suite.isOfSequences() ? STEPS : STEPS / 10;
    for (int steps = 0; steps < most; ) {
      TestCase again = suite.cases().get(cases.size() % suite.cases().size());
      cases.add(again.withNumber(cases.size() + 1));
      steps += steps(again);
    }
    return suite.withCases(cases);
  }

  private Path singleCalls(Language language, Builds builds) throws IOException {
    String example = language == Language.JAVA ? "ir-sensor" : COMPONENTS.get(language);
    return copy(home.resolve("examples").resolve(example), builds.directory().resolve("one-" + language.id()));
  }

  /** The activity of sequences without simulation time, with or without events of the world. */
  private Path activity(Language language, boolean events, Path directory) throws IOException {
    Path examples = home.resolve("examples");
    Path activity =
        copy(
            examples.resolve(COMPONENTS.get(language)),
            directory.resolve("states-" + language.id() + events));
    String model = Files.readString(examples.resolve("ir-sensor-states/LifeCycle.xml"));
    model = model.replace(" run_for=\"0.1\"", "");
    if (!events) {
      model =
          model
              .replaceAll("(?m)^ *<event .*$", "")
              .replaceAll("(?m)^ *<state name=\"(near|dropped)\".*$", "")
              .replace("|| dropped &amp;&amp; IndexOfSensor == 1 ", "")
              .replace("near ? 0.5 : 5.0", "5.0");
    }
    Files.writeString(activity.resolve("LifeCycle.xml"), model);
    String profile = Files.readString(activity.resolve("activity.yaml"));
    Files.writeString(
        activity.resolve("activity.yaml"),
        profile
            .replaceAll("(?m)^models: .*$", "models: [LifeCycle.xml]")
            .replaceAll("(?m)^  before: .*$", ""));
    return activity;
  }

  private static Path copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.toList()) {
        Path target = to.resolve(from.relativize(file));
        if (Files.isDirectory(file)) {
          Files.createDirectories(target);
        } else {
          Files.copy(file, target, StandardCopyOption.REPLACE_EXISTING);
        }
      }
    }
    return to;
  }
}
