package org.sitaf.cli.compare;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.SuiteCache;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.option.SeedOption;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.compare.CaseComparison;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.JunitXml;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Compares the behaviour of two versions of a component. */
@Command(
    name = "compare",
    description = {
      "Compares two versions of an activity: runs the cases of NEW's models with both, and reports"
          + " what they do differently. No expected values are needed.",
      "Exit code 0: no differences; 1: there are differences; 2: no case could be compared."
    },
    mixinStandardHelpOptions = true)
public final class CompareCommand implements Callable<Integer> {
  private static final int DIFFERENT = 1;
  private static final int MAX_ULP = 1 << 20;

  @Spec private @Nullable CommandSpec spec;

  @Parameters(
      index = "0",
      paramLabel = "BASE",
      description =
          "The earlier version: an activity folder, its ZIP archive, or FOLDER@REVISION of the Git"
              + " repository that holds it.")
  private String base = "";

  @Parameters(index = "1", paramLabel = "NEW", description = "The later version, likewise.")
  private String now = "";

  @Option(
      names = "--model",
      paramLabel = "NAME",
      description = "The test model of NEW; default: all its models.")
  private @Nullable String model;

  @Option(names = "--json", paramLabel = "FILE", description = "Also writes the result as JSON.")
  private @Nullable Path json;

  @Option(
      names = "--junit",
      paramLabel = "FILE",
      description = "Also writes JUnit XML, in which each differing case is a failure.")
  private @Nullable Path junit;

  @Option(
      names = "--ulp",
      paramLabel = "N",
      defaultValue = "4",
      description =
          "Numbers that differ by at most N units in the last place of the largest number of the"
              + " output do not count (default: ${DEFAULT-VALUE}).")
  private int ulp = 4;

  @Option(
      names = "--new-package",
      paramLabel = "NAME==VERSION",
      description =
          "NEW uses this release of a package: of the component itself, or for a Python component of"
              + " a package that it uses. BASE and NEW may be the same activity.")
  private @Nullable String newPackage;

  @Option(
      names = "--new-bridge",
      paramLabel = "ADDRESS",
      description =
          "NEW runs on the simulation bridge at this address (unix:/PATH or HOST:PORT), for example"
              + " one with another release of MuJoCo, started with --endpoints. BASE and NEW may be"
              + " the same activity.")
  private @Nullable String newBridge;

  @Mixin private final SeedOption seed = new SeedOption();

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  /** Reads and runs both versions. */
  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    requireUsableOptions();
    Version before = Version.read("BASE", base);
    Version after = Version.read("NEW", now);
    if (newPackage != null) {
      after = after.with(NewPackage.parse(newPackage));
    }
    Sitaf.print(after.activity().warnings(), err);
    List<TestModel> models = models(after);
    Merged merged = new Merged();
    if (model == null) {
      modelsOfBaseOnly(before, after, merged);
    }
    NewBridge bridge = newBridge == null ? null : NewBridge.at(newBridge, after.activity());
    int withWorld =
        after.activity().profile().world() == null ? 0 : (bridge == null ? 2 : 1) * models.size();
    LocalBuilds.OutputFolders none = new LocalBuilds.OutputFolders(null, null, false);
    Sandbox opened = sandbox.open();
    try (LocalBuilds builds =
            new LocalBuilds(Installation.current(), opened, false, none, withWorld);
        LocalBuilds elsewhere =
            bridge == null
                ? null
                : LocalBuilds.onBridge(Installation.current(), opened, none, bridge.address());
        ProgressLine progress = new ProgressLine(System.err)) {
      err.println("sandbox: " + builds.sandbox());
      if (bridge != null) {
        err.println("simulator of NEW: " + bridge.version());
      }
      err.flush();
      Runs runs = new Runs(builds, elsewhere == null ? builds : elsewhere, progress);
      for (TestModel each : models) {
        compare(before, after, each, runs, merged);
      }
    }
    Comparison comparison = merged.comparison();
    ComparisonText.print(comparison, List.copyOf(merged.otherTools), out);
    write(comparison, merged.results, after);
    return comparison.cases().isEmpty()
        ? Sitaf.UNUSABLE
        : comparison.differences().isEmpty() ? 0 : DIFFERENT;
  }

  private void requireUsableOptions() {
    if (ulp < 0 || ulp > MAX_ULP) {
      throw InvalidInputException.of("--ulp", "must be from 0 to " + MAX_ULP + ", not " + ulp);
    }
    if (json != null) {
      UserFiles.requireWritableFile("--json", json);
    }
    if (junit != null) {
      UserFiles.requireWritableFile("--junit", junit);
    }
  }

  private List<TestModel> models(Version after) {
    List<TestModel> all = after.activity().models();
    if (all.isEmpty()) {
      throw InvalidInputException.of(now, "names no test model in activity.yaml");
    }
    String wanted = model;
    return wanted == null
        ? all
        : List.of(
            after
                .activity()
                .model(wanted)
                .orElseThrow(
                    () ->
                        InvalidInputException.of(
                            "--model " + wanted,
                            "does not exist; NEW has "
                                + String.join(", ", all.stream().map(TestModel::name).toList()))));
  }

  private static void modelsOfBaseOnly(Version before, Version after, Merged merged) {
    before.activity().models().stream()
        .map(TestModel::name)
        .filter(name -> after.activity().model(name).isEmpty())
        .forEach(
            name ->
                merged.notComparable.add(
                    new NotComparable(name, 0, "", "NEW does not have this model")));
  }

  private void compare(Version before, Version after, TestModel tested, Runs runs, Merged merged)
      throws IOException, InterruptedException {
    BaseModel ofBase = BaseModel.of(before.activity(), after.activity(), tested);
    merged.notComparable.addAll(ofBase.notComparable());
    TestModel inBase = ofBase.model();
    if (inBase == null) {
      return;
    }
    TestSuite suite =
        new SuiteCache(Installation.current().state().resolve("suites"))
            .generate(tested, GenerationOptions.DEFAULT.withSeed(seed.value()))
            .suite();
    ModelComparison.Outcome outcome =
        new ModelComparison(
                suite,
                new CaseComparison(after.activity(), tested, suite, ulp, ofBase.judged()),
                new VersionRuns(runs.ofBase(), before, inBase),
                new VersionRuns(runs.ofNew(), after, tested),
                runs.progress())
            .run();
    merged.add(outcome);
  }

  private void write(Comparison comparison, List<TestResult> results, Version after)
      throws IOException {
    if (json != null) {
      Files.writeString(json, ComparisonJson.write(comparison));
    }
    if (junit != null) {
      List<TestResult> reported = ComparisonJunit.of(results, comparison);
      try (OutputStream file = new BufferedOutputStream(Files.newOutputStream(junit))) {
        JunitXml.write(after.activity().profile().name(), reported, file);
      }
    }
  }

  /** Where the versions run. */
  private record Runs(LocalBuilds ofBase, LocalBuilds ofNew, ProgressLine progress) {}

  /** The comparisons of all models. */
  private static final class Merged {
    private final List<Comparison> parts = new ArrayList<>();
    private final List<NotComparable> notComparable = new ArrayList<>();
    private final List<TestResult> results = new ArrayList<>();
    private final Set<String> otherTools = new LinkedHashSet<>();

    void add(ModelComparison.Outcome outcome) {
      parts.add(outcome.comparison());
      otherTools.addAll(outcome.otherTools());
      if (outcome.result() != null) {
        results.add(outcome.result());
      }
    }

    Comparison comparison() {
      parts.forEach(part -> notComparable.addAll(part.notComparable()));
      return new Comparison(
          parts.stream().flatMap(p -> p.cases().stream()).toList(),
          parts.stream().flatMap(p -> p.differences().stream()).toList(),
          parts.stream().flatMap(p -> p.lastBits().stream()).toList(),
          parts.stream().flatMap(p -> p.unstable().stream()).toList(),
          parts.stream().flatMap(p -> p.slower().stream()).toList(),
          notComparable);
    }
  }
}
