package org.sitaf.cli.score;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.analysis.MutatedModel;
import org.sitaf.agent.analysis.ScoredModel;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.SuiteCache;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.ActivityArguments;
import org.sitaf.cli.option.GenerationArguments;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.mutation.MutationScore;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.TestSuite;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Scores the specifications of an activity. */
@Command(
    name = "score",
    description = {
      "Puts faults between test driver and component, and counts those that the test cases notice:"
          + " wrong units, signs, offsets, swapped or ignored parameters, values of the case"
          + " before, exceptions, calls of required interfaces; in sequences also steps left out,"
          + " repeated or swapped, and answers of earlier calls. Prints what to add to the"
          + " specification.",
      "Exit code 0: every fault with an effect is noticed; 1: at least one is not; 2: the cases"
          + " could not be executed."
    },
    mixinStandardHelpOptions = true)
public final class ScoreCommand implements Callable<Integer> {
  private static final int NOT_NOTICED = 1;

  /** A user ends the command with Ctrl-C when it takes too long. */
  private static final Duration UNLIMITED = Duration.ofDays(1);

  @Spec private @Nullable CommandSpec spec;

  @Mixin private final ActivityArguments arguments = new ActivityArguments();

  @Option(
      names = "--budget",
      paramLabel = "N",
      description =
          "Maximum number of further cases of each model (default: 1000, fewer if the cases take"
              + " simulation time).")
  private @Nullable Integer budget;

  @Option(
      names = "--mutations",
      paramLabel = "N",
      description =
          "Also tests up to N mutations of the component's sources: operators, comparisons,"
              + " constants and returned values changed, calls left out. Each is a build.")
  private @Nullable Integer mutations;

  @Option(names = "--json", paramLabel = "FILE", description = "Also writes the score as JSON.")
  private @Nullable Path json;

  @Option(names = "--all", description = "Prints all faults that are not noticed.")
  private boolean all;

  @Mixin private final GenerationArguments generation = new GenerationArguments();

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    if (budget != null && budget < 0) {
      throw InvalidInputException.of("--budget", "must be at least 0, not " + budget);
    }
    if (mutations != null && mutations < 1) {
      throw InvalidInputException.of("--mutations", "must be at least 1, not " + mutations);
    }
    if (json != null) {
      UserFiles.requireWritableFile("--json", json);
    }
    Activity activity = Installation.read(UserFiles.folder(arguments.folder()));
    Sitaf.print(activity.warnings(), err);
    if (mutations != null && MutatedModel.count(activity) == 0) {
      throw InvalidInputException.of(
          "activity.yaml",
          "--mutations: the component has no sources in C++, Java or Python; leave --mutations out");
    }
    List<TestModel> models = arguments.modelsOf(activity);
    SuiteCache suites = new SuiteCache(Installation.current().state().resolve("suites"));
    Map<String, SpecificationScore> scores = new LinkedHashMap<>();
    Map<String, MutationScore> mutationScores = new LinkedHashMap<>();
    try (LocalBuilds builds =
        new LocalBuilds(
            Installation.current(),
            sandbox.open(),
            false,
            new LocalBuilds.OutputFolders(null, null, false),
            activity.profile().world() == null ? 0 : models.size())) {
      err.println("sandbox: " + builds.sandbox());
      err.flush();
      for (TestModel model : models) {
        GeneratedSuite generated = suites.generate(model, generation.options());
        Sitaf.print(generated.notes(), err);
        SpecificationScore score = score(builds, activity, model, generated.suite(), err);
        scores.put(model.name(), score);
        ScoreText.print(model.name(), score, all, out);
        if (mutations != null) {
          MutationScore mutated = mutated(builds, activity, model, generated.suite(), mutations);
          mutationScores.put(model.name(), mutated);
          ScoreText.print(model.name(), mutated, all, out);
        }
      }
    }
    if (json != null) {
      ScoreJson.write(scores, mutationScores, json);
    }
    boolean allNoticed =
        scores.values().stream().allMatch(s -> s.survivors().isEmpty())
            && mutationScores.values().stream().allMatch(s -> s.survivors().isEmpty());
    return allNoticed ? 0 : NOT_NOTICED;
  }

  private static MutationScore mutated(
      LocalBuilds builds, Activity activity, TestModel model, TestSuite suite, int max)
      throws InterruptedException {
    MutatedModel mutated =
        new MutatedModel(
            activity, suite, (changed, ends) -> builds.runUntil(changed, model, suite, ends));
    try (ProgressLine progress = new ProgressLine(System.err)) {
      progress.step(model.name() + ": testing mutations of the sources");
      int wanted = Math.min(max, MutatedModel.count(activity));
      return mutated.score(max, UNLIMITED, done -> progress.done(done, wanted));
    }
  }

  private SpecificationScore score(
      LocalBuilds builds, Activity activity, TestModel model, TestSuite suite, PrintWriter err)
      throws InterruptedException {
    return new ScoredModel(
            activity,
            model,
            suite,
            (cases, signals, observer) -> {
              err.println(
                  model.name()
                      + ": executing "
                      + suite.cases().size()
                      + " cases and "
                      + (cases.cases().size() - suite.cases().size())
                      + " further ones");
              err.flush();
              return builds.completed(
                  activity,
                  builds.record(
                      activity.withoutTiming(),
                      model.withoutTiming().withoutRelations(),
                      cases,
                      signals,
                      observer));
            })
        .score(budget);
  }
}
