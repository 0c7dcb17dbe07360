package org.sitaf.cli.explain;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.SuiteCache;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.ActivityArguments;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.option.SeedOption;
import org.sitaf.cli.run.CaseOptions;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.TestResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Explains the failures of an activity. */
@Command(
    name = "explain",
    description = {
      "Runs the cases of an activity and explains those that fail: the smallest sets of values that"
          + " fail with any other values, the simplest such case, and the boundary of a numeric"
          + " input. Further cases are executed for this.",
      "Exit code 0: every failure is explained, or no case failed; 1: a failure is not explained;"
          + " 2: the cases could not be executed."
    },
    mixinStandardHelpOptions = true)
public final class ExplainCommand implements Callable<Integer> {
  private static final int NOT_EXPLAINED = 1;

  @Spec private @Nullable CommandSpec spec;

  @Mixin private final ActivityArguments arguments = new ActivityArguments();

  @Option(
      names = "--cases",
      paramLabel = "NUMBERS",
      converter = CaseOptions.NumbersConverter.class,
      description = "Explains only these failed cases, such as 3,7; default: all that failed.")
  private @Nullable CaseNumbers cases;

  @Option(
      names = "--budget",
      paramLabel = "N",
      defaultValue = "500",
      description = "Maximum number of further cases of each model (default: ${DEFAULT-VALUE}).")
  private int budget = 500;

  @Option(names = "--json", paramLabel = "FILE", description = "Also writes the causes as JSON.")
  private @Nullable Path json;

  @Option(
      names = "--bundles",
      paramLabel = "FOLDER",
      description =
          "Also writes a zip for each cause: the activity with the simplest case, for"
              + " ./sitaf replay.")
  private @Nullable Path bundles;

  @Mixin private final SeedOption seed = new SeedOption();

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    if (budget < 0) {
      throw InvalidInputException.of("--budget", "must be at least 0, not " + budget);
    }
    if (json != null) {
      UserFiles.requireWritableFile("--json", json);
    }
    if (bundles != null) {
      UserFiles.requireWritableFolder("--bundles", bundles);
    }
    FileTree files = UserFiles.folder(arguments.folder());
    Activity activity = Installation.read(files);
    Sitaf.print(activity.warnings(), err);
    List<TestModel> models = arguments.modelsOf(activity);
    for (TestModel each : models) {
      if (bundles != null && each.sequence() != null) {
        throw InvalidInputException.of(
            each.source(),
            "--bundles does not support models with a sequence_spec; select another model by"
                + " --model, or leave --bundles out");
      }
    }
    if (cases != null && models.size() > 1) {
      throw InvalidInputException.of(
          "--cases",
          "needs --model, since the activity has several: "
              + models.stream().map(TestModel::name).collect(Collectors.joining(", ")));
    }
    SuiteCache suites = new SuiteCache(Installation.current().state().resolve("suites"));
    Map<String, Explanation> explanations = new LinkedHashMap<>();
    try (LocalBuilds builds =
        new LocalBuilds(
            Installation.current(),
            sandbox.open(),
            false,
            new LocalBuilds.OutputFolders(null, null, false),
            activity.profile().world() == null ? 0 : models.size() * (budget + 1))) {
      err.println("sandbox: " + builds.sandbox());
      err.flush();
      for (TestModel model : models) {
        GeneratedSuite generated =
            suites.generate(model, GenerationOptions.DEFAULT.withSeed(seed.value()));
        Sitaf.print(generated.notes(), err);
        Explanation explanation = explain(activity, model, generated.suite(), builds, out, err);
        explanations.put(model.name(), explanation);
        ExplanationText.print(model.name(), explanation, cases == null, out);
        if (bundles != null) {
          new Bundles(builds, activity, files, model, generated.suite())
              .write(explanation, bundles, out);
        }
      }
    }
    if (json != null) {
      ExplanationJson.write(explanations, json);
    }
    return explanations.values().stream().allMatch(e -> e.unexplained().isEmpty())
        ? 0
        : NOT_EXPLAINED;
  }

  private Explanation explain(
      Activity activity,
      TestModel model,
      TestSuite suite,
      LocalBuilds builds,
      PrintWriter out,
      PrintWriter err)
      throws InterruptedException {
    Set<Integer> chosen = null;
    if (cases != null) {
      if (!cases.missing(suite).isEmpty()) {
        throw InvalidInputException.of(
            "--cases " + cases.missing(suite).get(0),
            "does not exist; " + model.name() + " has " + suite.cases().size() + " cases");
      }
      chosen = cases.select(suite).cases().stream().map(TestCase::no).collect(Collectors.toSet());
    }
    TestResult result =
        builds.completed(
            activity, builds.run(activity.withoutTiming(), model.withoutTiming(), suite));
    if (result.isSuspect()) {
      throw InvalidInputException.of(
          model.name(),
          "the verdicts cannot be trusted: " + String.join("; ", result.suspicions()));
    }
    if (result.summary().pass() + result.summary().fail() + result.summary().error() == 0) {
      throw InvalidInputException.of(model.name(), "no case was executed");
    }
    if (chosen != null) {
      Set<Integer> selected = chosen;
      ExplanationText.printNotFailed(
          model.name(),
          result.cases().stream().filter(c -> selected.contains(c.no())).toList(),
          out);
    }
    try {
      return Explanation.of(
          model,
          suite,
          result.cases(),
          activity.world(),
          chosen,
          new FurtherBuilds(builds, activity, model, suite, err),
          budget);
    } catch (IllegalStateException e) {
      throw InvalidInputException.of(model.name(), String.valueOf(e.getMessage()));
    }
  }
}
