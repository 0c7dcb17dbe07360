package org.sitaf.cli.falsify;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.SuiteCache;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.ActivityArguments;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.option.SeedOption;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.falsify.Falsification;
import org.sitaf.core.falsify.Falsification.Found;
import org.sitaf.core.falsify.SearchSpace;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.TrajectoryCondition;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.databind.json.JsonMapper;

/** Searches for a case that violates a trajectory condition. */
@Command(
    name = "falsify",
    description = {
      "Searches the ranges of the numeric inputs of a model for the case with the smallest margin of"
          + " a trajectory condition: first the cases of the suite, then with CMA-ES.",
      "Exit code 0: no case violates the condition; 1: the printed case does; 2: it cannot be"
          + " searched."
    },
    mixinStandardHelpOptions = true)
public final class FalsifyCommand implements Callable<Integer> {
  private static final int VIOLATED = 1;

  @Spec private @Nullable CommandSpec spec;

  @Mixin private final ActivityArguments arguments = new ActivityArguments();

  @Option(
      names = "--condition",
      paramLabel = "NAME",
      description = "The trajectory condition; default: all of the model.")
  private @Nullable String condition;

  @Option(
      names = "--budget",
      paramLabel = "N",
      defaultValue = "200",
      description = "Maximum number of executed cases (default: ${DEFAULT-VALUE}).")
  private int budget = 200;

  @Option(
      names = "--random",
      description = "Executes cases with random values of the ranges only, to compare.")
  private boolean random;

  @Option(names = "--json", paramLabel = "FILE", description = "Also writes the result as JSON.")
  private @Nullable Path json;

  @Option(names = "--keep", description = "Adds the case to the case_list of the model.")
  private boolean keep;

  @Mixin private final SeedOption seed = new SeedOption();

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    if (budget < 1) {
      throw InvalidInputException.of("--budget", "must be at least 1, not " + budget);
    }
    if (json != null) {
      UserFiles.requireWritableFile("--json", json);
    }
    Activity activity = Installation.read(UserFiles.folder(arguments.folder()));
    Sitaf.print(activity.warnings(), err);
    TestModel model = model(activity);
    SearchSpace space = SearchSpace.of(model, seed.value());
    if (space.dimensions() == 0) {
      throw InvalidInputException.of(
          model.source(),
          "has no numeric TDI or TDSD with a range to search; add a test_spec of type BVA, ECP or"
              + " RANDOM");
    }
    TestSuite suite =
        new SuiteCache(Installation.current().state().resolve("suites"))
            .generate(model, GenerationOptions.DEFAULT.withSeed(seed.value()))
            .suite();
    List<List<Value>> first =
        suite.cases().stream().filter(TestCase::valid).map(c -> values(model, c)).toList();
    Found found;
    try (LocalBuilds builds =
        new LocalBuilds(
            Installation.current(),
            sandbox.open(),
            false,
            new LocalBuilds.OutputFolders(null, null, false),
            activity.profile().world() == null ? 0 : budget)) {
      err.println("sandbox: " + builds.sandbox());
      err.flush();
      MarginRuns runs = new MarginRuns(builds, activity, model, suite, condition, err);
      Falsification search = new Falsification(space, budget, seed.value(), runs);
      found = random ? search.searchUniformly(first) : search.search(first);
    }
    if (found.row().isEmpty()) {
      throw InvalidInputException.of(
          model.source(), "no case of the search has a margin; see ./sitaf run for the reasons");
    }
    print(model, found, out);
    if (json != null) {
      write(model, found, json);
    }
    if (keep) {
      Path file = arguments.folder().resolve(model.source());
      KeptCaseText.add(file, model, found.row());
      out.println("added to the case_list of " + file);
    }
    return found.outcome().violated() ? VIOLATED : 0;
  }

  /** The only model with the condition. */
  private TestModel model(Activity activity) {
    List<TestModel> all =
        arguments.modelsOfSingleCalls(activity, "falsify").stream()
            .filter(m -> !m.trajectoryConditions().isEmpty())
            .toList();
    List<TestModel> fitting =
        all.stream()
            .filter(m -> condition == null || names(m).contains(Objects.requireNonNull(condition)))
            .toList();
    if (fitting.size() == 1) {
      // The search needs margins only.
      return fitting.get(0).withoutRelations();
    }
    List<String> known = all.stream().map(m -> m.name() + ": " + names(m)).toList();
    if (all.isEmpty()) {
      throw InvalidInputException.of(
          arguments.folder().toString(), "no model has a trajectory condition");
    }
    throw InvalidInputException.of(
        fitting.isEmpty() ? "--condition " + condition : arguments.folder().toString(),
        fitting.isEmpty()
            ? "does not exist; the models have " + String.join(", ", known)
            : "several models have trajectory conditions; choose one with --model: "
                + String.join(", ", known));
  }

  private static List<String> names(TestModel model) {
    return model.trajectoryConditions().stream().map(TrajectoryCondition::name).toList();
  }

  private static List<Value> values(TestModel model, TestCase testCase) {
    return java.util.stream.IntStream.range(0, model.inputs().size())
        .mapToObj(i -> model.inputs().get(i).value(testCase.values().get(i)))
        .toList();
  }

  private static void print(TestModel model, Found found, PrintWriter out) {
    out.printf(
        "%s: %s, margin %s, after %d cases%n",
        found.outcome().condition(),
        found.outcome().violated() ? "violated" : "not violated",
        found.outcome().margin(),
        found.executions());
    for (int i = 0; i < model.inputs().size(); i++) {
      out.println("  " + model.inputs().get(i).name() + " = " + found.row().get(i).literal());
    }
  }

  private static void write(TestModel model, Found found, Path file) throws IOException {
    Map<String, Object> inputs = new LinkedHashMap<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      Value value = found.row().get(i);
      inputs.put(
          model.inputs().get(i).name(),
          value instanceof Value.Whole whole
              ? whole.number()
              : value instanceof Value.Real real && Double.isFinite(real.number())
                  ? (Object) real.number()
                  : value.literal());
    }
    double margin = found.outcome().margin();
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("executions", found.executions());
    result.put("margin", Double.isFinite(margin) ? (Object) margin : Double.toString(margin));
    result.put("inputs", inputs);
    result.put("condition", found.outcome().condition());
    result.put("violated", found.outcome().violated());
    Files.writeString(
        file, new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(result) + "\n");
  }
}
