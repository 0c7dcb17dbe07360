import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.ActivityProfile.Language;

/**
 * Measures test applications against their targets: each language on its infrared example, with the
 * simulation in its own process. Absolute times hold for a quiet machine; the ratios beside them
 * were measured in the same run.
 */
public final class HarnessBenchmark {
  private static final int FEW = 1_000;
  private static final int CHANGES = 9;
  private static final int WARM_UP = 4;

  /** What a language is to keep. */
  private record Targets(
      String example, double overheadMicros, double casesPerSecond, double emptyMicros, double changeSeconds) {}

  private static final Map<Language, Targets> TARGETS =
      Map.of(
          Language.JAVA, new Targets("ir-sensor", 100, 20_000, 1, 1.5),
          Language.CPP, new Targets("ir-sensor-cpp", 100, 20_000, 1, 6),
          Language.PYTHON, new Targets("ir-sensor-python", 300, 5_000, Double.NaN, 1));

  private double emptyJvmSeconds;
  private final List<String> shortOf = new ArrayList<>();

  public static void main(String[] arguments) throws Exception {
    System.exit(new HarnessBenchmark().measure() ? 0 : 1);
  }

  private boolean measure() throws Exception {
    Path home = Path.of(System.getProperty("sitaf.home"));
    Path state = home.resolve(".sitaf");
    Path directory = Files.createTempDirectory("sitaf-bench-");
    Toolchains toolchains =
        new Toolchains(new ToolchainPlaces(state.resolve("dist/agent"), directory.resolve("cache")));
    List<String> bridge = List.of(state.resolve("venv/bin/python").toString(), "-m", "sitaf_bridge");
    try (Simulator simulator = Simulator.started(bridge, directory.resolve("simulator"))) {
      Builds builds = new Builds(simulator, toolchains, SandboxMode.AUTO.open(), directory);
      System.out.println(SandboxMode.AUTO.open().description());
      double bare =
          BareSimulation.microsPerCase(
              simulator.target(), home.resolve("examples/ir-sensor/world/ir.world.yaml"));
      System.out.printf(
          Locale.ROOT, "%-58s %10.1f us%n", "the simulation alone, in bulk, a case", bare);
      emptyJvmSeconds = emptyJvm();
      System.out.printf(
          Locale.ROOT, "%-58s %10.2f s%n", "the start of an empty JVM", emptyJvmSeconds);
      for (Language language : Language.values()) {
        Path example = home.resolve("examples").resolve(TARGETS.get(language).example());
        if (toolchains.of(language).isEmpty()) {
          System.out.println(language.spelling() + ": skipped: " + toolchains.lackOf(language));
        } else if (!Files.isDirectory(example)) {
          System.out.println(language.spelling() + ": skipped: there is no " + example);
        } else {
          measure(language, example, builds, bare);
        }
      }
    } finally {
      try (Stream<Path> files = Files.walk(directory)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
    System.out.println(
        "harness: " + (shortOf.isEmpty() ? "held" : "short: " + String.join(", ", shortOf)));
    return shortOf.isEmpty();
  }

  private void measure(Language language, Path example, Builds builds, double bare)
      throws Exception {
    Targets targets = TARGETS.get(language);
    String name = language.spelling();
    Builds.Run few = builds.run(example, FEW, "");
    Builds.Run many = builds.run(example, FEW * 21, "");
    // Of two lengths of the same suite: what one case takes, without start and end of the process.
    double perCase = (many.casesMicros() - few.casesMicros()) / (many.cases() - few.cases());
    row(name + ": a case, end to end", 1e6 / perCase, "cases/s", targets.casesPerSecond(), true, perCase / bare);
    double overhead = perCase - bare - many.medianComponentMicros();
    row(name + ": a case beyond simulation and component", overhead, "us", targets.overheadMicros(), false, overhead / bare);

    Path empty = EmptyComponent.write(language, builds.directory().resolve("empty-" + name));
    double call = builds.run(empty, FEW, "").medianComponentMicros();
    row(name + ": processing time of an empty component", call, "us", targets.emptyMicros(), false, Double.NaN);

    List<Double> seconds = new ArrayList<>();
    for (int i = 0; i < WARM_UP + CHANGES; i++) {
      double second = builds.run(example, 0, "change " + i).firstCaseSeconds();
      if (i >= WARM_UP) {
        seconds.add(second);
      }
    }
    seconds.sort(null);
    row(name + ": from a changed source to the first case", seconds.get(CHANGES / 2), "s", targets.changeSeconds(), false, Double.NaN);
    System.out.printf(
        Locale.ROOT, "%-58s %.1f times the start of an empty JVM%n", "", seconds.get(CHANGES / 2) / emptyJvmSeconds);
  }

  /** What the machine takes at present to start a process of Java and no more. */
  private static double emptyJvm() throws Exception {
    List<Double> seconds = new ArrayList<>();
    for (int i = 0; i < CHANGES; i++) {
      long began = System.nanoTime();
      new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-version")
          .redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .start()
          .waitFor();
      seconds.add((System.nanoTime() - began) / 1e9);
    }
    seconds.sort(null);
    return seconds.get(CHANGES / 2);
  }

  private void row(String what, double value, String unit, double target, boolean atLeast, double ratio) {
    boolean hasTarget = !Double.isNaN(target);
    boolean held = !hasTarget || (atLeast ? value >= target : value < target);
    if (!held) {
      shortOf.add(what);
    }
    System.out.printf(
        Locale.ROOT,
        "%-58s %10s %-8s %-18s %-6s%s%n",
        what,
        String.format(Locale.ROOT, value < 10 ? "%.2f" : "%.0f", value),
        unit,
        hasTarget ? (atLeast ? "at least " : "under ") + (target < 10 ? target : (long) target) : "",
        hasTarget ? (held ? "held" : "SHORT") : "",
        Double.isNaN(ratio) ? "" : String.format(Locale.ROOT, "%.1f times the simulation alone", ratio));
  }
}
