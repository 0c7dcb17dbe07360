import java.io.ByteArrayInputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.simulation.BuildSimulator;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.PostConditions;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;

/**
 * Measures oracles against their targets. Builds with and without conditions alternate, so that
 * their ratio is valid on a machine with other load, too.
 */
public final class OraclesBenchmark {
  private static final int RUNS = 3;
  private static final int LONG_CASES = 8;
  private static final int SENSOR_CASES = 1_000;
  private static final int SAMPLES = 100_000;
  private static final int ELEMENTS = 1_000;
  private static final int READINGS = 15;

  private static final String LIST = "<trajectory_condition_spec_list>.*</trajectory_condition_spec_list>";

  private final Path home = Path.of(System.getProperty("sitaf.home"));
  private final Rows rows = new Rows();

  /** Takes no arguments. */
  public static void main(String[] arguments) throws Exception {
    System.exit(new OraclesBenchmark().measure() ? 0 : 1);
  }

  private boolean measure() throws Exception {
    readLargeModel();
    evaluateNestedIntervals();
    Path state = home.resolve(".sitaf");
    Path directory = Files.createTempDirectory("sitaf-bench-");
    Toolchains toolchains =
        new Toolchains(new ToolchainPlaces(state.resolve("dist/agent"), state.resolve("bench")));
    List<String> bridge = List.of(state.resolve("venv/bin/python").toString(), "-m", "sitaf_bridge");
    Sandbox sandbox = SandboxMode.AUTO.open();
    System.out.printf(
        Locale.ROOT,
        "%s; %d processors with a load of %.1f%n",
        sandbox.description(),
        Runtime.getRuntime().availableProcessors(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
    try (Simulator simulator =
        Simulator.started(bridge, directory.resolve("simulator"), sandbox, Simulator.UNLIMITED)) {
      Builds builds = new Builds(simulator, toolchains, sandbox, directory);
      longCase(
          "a periodic controller",
          "joint-settling",
          "Settle.xml",
          List.of(
              "eventually[0, 2](always(abs(angle_held - angle) <= 0.05))",
              "always(abs(speed) <= 40.0)",
              "always[1, 5](abs(motor.effort) <= 8.0)"),
          builds);
      longCase(
          "a robot that drives",
          "touchless-approach",
          "Approach.xml",
          List.of(
              "always(bumped == 0.0)",
              "eventually(always(base.linear.command == 0.0))",
              "always(robot_x <= 2.0 && abs(robot_y) <= 2.0)"),
          builds);
      sensorCases(simulator, builds);
    } finally {
      toolchains.stop();
      try (Stream<Path> files = Files.walk(directory)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
    return rows.end("oracles");
  }

  /** Cases of 5 s at 500 steps a second, with three trajectory conditions and without. */
  private void longCase(String what, String example, String model, List<String> conditions, Builds builds)
      throws Exception {
    Path source = home.resolve("examples").resolve(example);
    Path folder = builds.directory().resolve(example);
    Path timed = Variants.of(source, folder.resolve("timed"), model, "run_for=\"[0-9.]+\"", "run_for=\"5\"");
    Path plain = Variants.of(timed, folder.resolve("plain"), model, LIST, "");
    Path judged =
        Variants.of(timed, folder.resolve("judged"), model, LIST, Variants.conditions("trajectory_condition", conditions));
    double[] medians = alternating(builds, LongSuite.repeated(LONG_CASES), plain, judged);
    rows.row(
        "three trajectory conditions over 5 s: " + what,
        medians[1] / medians[0], "", 1.3, false,
        medians[1] / medians[0], String.format(Locale.ROOT, "without (%.1f ms a case)", medians[0] / 1e3));
  }

  /** The median time per case of each folder, in microseconds; their builds alternate. */
  private static double[] alternating(Builds builds, UnaryOperator<TestSuite> cases, Path... folders)
      throws Exception {
    List<List<Double>> times = new ArrayList<>();
    for (Path folder : folders) {
      builds.run(folder, cases, "");
      times.add(new ArrayList<>());
    }
    for (int i = 0; i < RUNS; i++) {
      for (int f = 0; f < folders.length; f++) {
        Builds.Run run = builds.run(folders[f], cases, "");
        // From the first result to the last.
        times.get(f).add(run.casesMicros() / (run.cases() - 1));
      }
    }
    return times.stream().mapToDouble(t -> t.stream().sorted().toList().get(RUNS / 2)).toArray();
  }

  /** Cases that only read a sensor, with five conditions of ten operations each, in C++. */
  private void sensorCases(Simulator simulator, Builds builds) throws Exception {
    Path example = home.resolve("examples/ir-sensor-cpp");
    double bare;
    try (BuildSimulator alone = simulator.forBuild()) {
      bare = BareSimulation.microsPerCase(alone.target(), example.resolve("world/ir.world.yaml"));
    }
    Path folder = builds.directory().resolve("sensor");
    Path plain = Variants.of(example, folder.resolve("plain"), "GetInfraredData.xml", "<description>", "<description>A ");
    List<String> tenOperations =
        IntStream.range(0, 5)
            .mapToObj(
                i ->
                    "abs(actual - Distance) * %d.0 + Distance * 2.0 - actual <= 100.0 + Distance && actual >= -1.0 && Distance >= 0.0"
                        .formatted(i + 2))
            .toList();
    Path judged =
        Variants.of(
            example, folder.resolve("judged"), "GetInfraredData.xml", "</output_spec_list>",
            "</output_spec_list>" + Variants.conditions("post_condition", tenOperations));
    double[] medians =
        alternating(builds, LongSuite.withDistinctDistances(SENSOR_CASES), plain, judged);
    rows.row(
        "C++: sensor-only cases with five conditions",
        1e6 / medians[1], "cases/s", 15_000, true,
        medians[1] / bare, "the time of the simulation");
    rows.row(
        "C++: sensor-only cases without conditions",
        1e6 / medians[0], "cases/s", Double.NaN, true,
        medians[0] / bare, "the time of the simulation");
  }

  private void readLargeModel() throws Exception {
    byte[] text = Variants.largeModel(ELEMENTS).getBytes(StandardCharsets.UTF_8);
    List<Double> seconds = new ArrayList<>();
    List<Double> parsing = new ArrayList<>();
    for (int i = 0; i < READINGS; i++) {
      long began = System.nanoTime();
      TestModel model = TestModelXml.read(new ByteArrayInputStream(text), "Large.xml");
      // Compiles the conditions, which are checked when a model is read.
      if (PostConditions.of(model).size() != ELEMENTS) {
        throw new IllegalStateException("the model was not read");
      }
      seconds.add((System.nanoTime() - began) / 1e9);
      began = System.nanoTime();
      DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new ByteArrayInputStream(text));
      parsing.add((System.nanoTime() - began) / 1e9);
    }
    rows.row(
        "reading a model of 1,000 elements and conditions, first",
        seconds.get(0), "s", Double.NaN, false, seconds.get(0) / parsing.get(0), "parsing its XML");
    rows.row(
        "reading a model of 1,000 elements and conditions",
        median(seconds), "s", 0.3, false, median(seconds) / median(parsing), "parsing its XML");
  }

  /** The robustness of nested intervals over many samples, beyond that of their atom. */
  private void evaluateNestedIntervals() throws Exception {
    double[] signal = new double[SAMPLES];
    for (int k = 0; k < SAMPLES; k++) {
      signal[k] = Math.sin(k / 50.0) + 0.001 * (k % 7);
    }
    Trace trace = new Trace(0, 1_000_000, List.of("x"), List.of(signal));
    TestModel model =
        TestModelXml.read(
            new ByteArrayInputStream(
                ("<test_model><name>M</name><target interface='I' method='m'/><input_spec_list/>"
                        + Variants.conditions(
                            "trajectory_condition",
                            List.of("x > -2.0", "always[1, 9](eventually[2, 5](x > -2.0))"))
                        + "<order_of_combinations>2</order_of_combinations></test_model>")
                    .getBytes(StandardCharsets.UTF_8)),
            "M.xml");
    Diagnostics diagnostics = new Diagnostics();
    TrajectoryConditions conditions =
        TrajectoryConditions.compile(model, List.of("x"), 1_000, diagnostics);
    diagnostics.throwIfErrors();
    double atom = milliseconds(conditions, 0, trace);
    double nested = milliseconds(conditions, 1, trace);
    rows.row(
        "always[a,b] eventually[c,d] over 100,000 samples",
        nested - atom, "ms", 50, false, nested / atom,
        String.format(Locale.ROOT, "its atom (%.0f ns a sample)", atom * 1e6 / SAMPLES));
  }

  private static double milliseconds(TrajectoryConditions conditions, int index, Trace trace)
      throws Exception {
    List<Double> times = new ArrayList<>();
    for (int i = 0; i < READINGS; i++) {
      long began = System.nanoTime();
      conditions.evaluate(index, trace, Map.of());
      times.add((System.nanoTime() - began) / 1e6);
    }
    return median(times);
  }

  private static double median(List<Double> values) {
    return values.stream().sorted().collect(Collectors.toList()).get(values.size() / 2);
  }
}
