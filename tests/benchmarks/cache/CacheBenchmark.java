import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;

/**
 * Edits activities at random and compiles each twice: with shared caches and
 * without. The results must be identical, and a model of the includes defines which
 * units may be compiled again.
 */
public final class CacheBenchmark {
  private static final int SHOWN = 20;

  private final Path home = Path.of(System.getProperty("sitaf.home"));
  private final List<String> faults = new ArrayList<>();
  private final Set<String> seen = new HashSet<>();
  private int builds;
  private int stale;
  private int needless;
  private int missed;
  private int units;
  private int compiledUnits;
  private int applications;
  private int compiledApplications;
  private int rejected;
  private double cachedSeconds;
  private double cleanSeconds;

  public static void main(String[] arguments) throws Exception {
    int edits = 500;
    long seed = 12;
    for (int i = 0; i + 1 < arguments.length; i += 2) {
      switch (arguments[i]) {
        case "--edits" -> edits = Integer.parseInt(arguments[i + 1]);
        case "--seed" -> seed = Long.parseLong(arguments[i + 1]);
        default -> throw new IllegalArgumentException("usage: cache [--edits N] [--seed N]");
      }
    }
    System.exit(new CacheBenchmark().measure(edits, seed) ? 0 : 1);
  }

  private boolean measure(int edits, long seed) throws Exception {
    Path folder = Files.createTempDirectory("sitaf-cache-");
    try {
      Sandbox sandbox = SandboxMode.AUTO.open();
      Path installation = home.resolve(".sitaf/dist/agent");
      Path runtimes = home.resolve(".sitaf/cache/cpp/runtime");
      Builds cached = new Builds(Files.createDirectory(folder.resolve("cached")), installation, runtimes, sandbox);
      Builds clean = new Builds(Files.createDirectory(folder.resolve("clean")), installation, runtimes, sandbox);
      Path objects = Libraries.write(folder.resolve("libraries"));
      List<Project> projects = Shapes.all(objects, home);
      Random random = new Random(seed);
      Edits changes = new Edits(random, projects, objects);
      System.out.printf(
          "%s; %d activities, %d edits, seed %d%n", sandbox.description(), projects.size(), edits, seed);
      // A short run does not create activities that it would not edit.
      List<Project> used = projects.subList(0, projects.size());
      Set<Project> begun = new HashSet<>();
      for (int i = 0; i < edits; i++) {
        Project project = used.get(random.nextInt(used.size()));
        if (begun.add(project)) {
          build(project, "initial state", cached, clean);
        }
        build(project, changes.edit(project), cached, clean);
        if ((i + 1) % 50 == 0) {
          System.out.printf("%d edits, %d builds%n", i + 1, builds);
        }
      }
      return report(edits);
    } finally {
      Builds.delete(folder);
    }
  }

  private void build(Project project, String edit, Builds cached, Builds clean) throws Exception {
    long began = System.nanoTime();
    Builds.Built with = cached.build(project);
    long between = System.nanoTime();
    clean.forget();
    Builds.Built without = clean.build(project);
    cachedSeconds += (between - began) / 1e9;
    cleanSeconds += (System.nanoTime() - between) / 1e9;
    builds++;
    String what = project.name + ", " + edit;
    if (without.files().containsKey("rejected")) {
      rejected++;
    }
    if (!same(with.files(), without.files())) {
      stale++;
      faults.add(what + ": differs from the build without caches: " + different(with.files(), without.files()));
    }
    Set<String> touched = new TreeSet<>();
    if (project.java) {
      applications++;
      if (seen.add(project.trace())) {
        touched.add("application");
      }
      compiledApplications += with.asked() ? 1 : 0;
      count(what, with.asked() ? Set.of("application") : Set.of(), touched);
    } else {
      Map<String, String> traces = IncludeModel.traces(project);
      traces.forEach(
          (unit, trace) -> {
            if (seen.add(trace)) {
              touched.add(unit);
            }
          });
      units += traces.size();
      compiledUnits += with.units().size();
      if (!without.units().equals(traces.keySet())) {
        faults.add(what + ": the model has the units " + traces.keySet() + ", the compiler " + without.units());
      }
      count(what, with.units(), touched);
    }
  }

  private void count(String what, Set<String> compiled, Set<String> touched) {
    for (String unit : compiled) {
      if (!touched.contains(unit)) {
        needless++;
        faults.add(what + ": compiled without a change: " + unit);
      }
    }
    for (String unit : touched) {
      if (!compiled.contains(unit)) {
        missed++;
        faults.add(what + ": changed but not compiled: " + unit);
      }
    }
  }

  private static boolean same(Map<String, byte[]> some, Map<String, byte[]> others) {
    return some.keySet().equals(others.keySet())
        && some.entrySet().stream().allMatch(e -> Arrays.equals(e.getValue(), others.get(e.getKey())));
  }

  private static Set<String> different(Map<String, byte[]> some, Map<String, byte[]> others) {
    Set<String> paths = new TreeSet<>(some.keySet());
    paths.addAll(others.keySet());
    paths.removeIf(p -> Arrays.equals(some.get(p), others.get(p)));
    return paths;
  }

  private boolean report(int edits) {
    faults.stream().limit(SHOWN).forEach(System.out::println);
    List<String> shortOf = new ArrayList<>();
    row("builds that differ from one without caches, of " + builds, stale, shortOf);
    row("units and applications compiled without a change", needless, shortOf);
    row("units and applications changed but not compiled", missed, shortOf);
    row("other differences between model and compiler", faults.size() - stale - needless - missed, shortOf);
    print("units compiled, of " + units, compiledUnits, "");
    print("applications in Java compiled, of " + applications, compiledApplications, "");
    print("builds that the compiler rejected, with caches and without", rejected, "");
    print("time of a build with caches", cachedSeconds / builds, "s");
    print("time of a build without caches", cleanSeconds / builds, "s");
    System.out.println("cache: " + (shortOf.isEmpty() ? "held" : "short: " + String.join(", ", shortOf)));
    return shortOf.isEmpty();
  }

  private static void print(String what, double value, String unit) {
    System.out.printf(Locale.ROOT, "%-66s %8s %s%n", what, unit.isEmpty() ? String.valueOf((int) value) : String.format(Locale.ROOT, "%.2f", value), unit);
  }

  private static void row(String what, int value, List<String> shortOf) {
    if (value != 0) {
      shortOf.add(what);
    }
    System.out.printf(Locale.ROOT, "%-66s %8d   none   %s%n", what, value, value == 0 ? "held" : "SHORT");
  }
}
