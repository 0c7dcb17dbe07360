package org.sitaf.cli.campaign;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.campaign.CampaignRuns.Healthy;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.SuiteCache;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.ActivityArguments;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.option.SeedOption;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.campaign.CampaignCase;
import org.sitaf.core.campaign.CampaignResult;
import org.sitaf.core.campaign.Classification;
import org.sitaf.core.campaign.FaultCampaign;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Lets the devices of the world fail, alone and in pairs. */
@Command(
    name = "campaign",
    description = {
      "Runs cases of a model with every fault that the devices of its world can have, alone and in"
          + " pairs, and prints what the component does.",
      "Exit code 0: it copes with all faults; 1: a fault breaks a condition or crashes it; 2: the"
          + " campaign could not be run."
    },
    mixinStandardHelpOptions = true)
public final class CampaignCommand implements Callable<Integer> {
  private static final int FAILED = 1;

  /** Cases that are run without faults, and those of them that are run with faults. */
  private static final int MAX_HEALTHY = 12;

  private static final int MAX_BASES = 4;

  @Spec private @Nullable CommandSpec spec;

  @Mixin private final ActivityArguments arguments = new ActivityArguments();

  @Option(
      names = "--max-cases",
      paramLabel = "N",
      defaultValue = "200",
      description = "Maximum number of cases with faults (default: ${DEFAULT-VALUE}).")
  private int maxCases = 200;

  @Option(
      names = "--random",
      description = "Random single faults, values and times instead, to compare with.")
  private boolean random;

  @Option(names = "--json", paramLabel = "FILE", description = "Also writes the result as JSON.")
  private @Nullable Path json;

  @Mixin private final SeedOption seed = new SeedOption();

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    if (json != null) {
      UserFiles.requireWritableFile("--json", json);
    }
    Activity activity = Installation.read(UserFiles.folder(arguments.folder()));
    Sitaf.print(activity.warnings(), err);
    TestModel model = model(activity);
    WorldDescription world = activity.world();
    if (world == null) {
      throw InvalidInputException.of(
          arguments.folder().toString(), "has no world, so no devices that can fail");
    }
    TestSuite suite =
        new SuiteCache(Installation.current().state().resolve("suites"))
            .generate(model, GenerationOptions.DEFAULT.withSeed(seed.value()))
            .suite();
    int needed = new FaultCampaign(world, 1, 0, seed.value()).size();
    if (needed == 0) {
      throw InvalidInputException.of(world.path(), "has no devices that can fail");
    }
    if (maxCases < needed) {
      throw InvalidInputException.of(
          "--max-cases " + maxCases,
          "must be at least " + needed + ", the number of faults of the devices");
    }
    List<Healthy> bases;
    CampaignResult result;
    try (LocalBuilds builds =
        new LocalBuilds(
            Installation.current(),
            sandbox.open(),
            false,
            new LocalBuilds.OutputFolders(null, null, false),
            2)) {
      err.println("sandbox: " + builds.sandbox());
      err.flush();
      CampaignRuns runs = new CampaignRuns(builds, activity, model, suite, err);
      bases = bases(runs.healthy(chosen(suite, model)), model);
      double seconds = bases.stream().mapToDouble(Healthy::seconds).min().orElse(0);
      FaultCampaign campaign = new FaultCampaign(world, bases.size(), seconds, seed.value());
      List<CampaignCase> cases = random ? campaign.random(maxCases) : campaign.cases(maxCases);
      result =
          new CampaignResult(runs.faulty(cases, bases, new Classification(model.outputs(), world)));
    }
    if (result.entries().isEmpty()) {
      throw InvalidInputException.of(
          model.source(), "no case with faults was executed; see ./sitaf run for the reasons");
    }
    new CampaignText(world, result, out).print();
    if (json != null) {
      Files.writeString(
          json, CampaignJson.write(model, result, bases.stream().map(Healthy::values).toList()));
    }
    return result.hasFailures() ? FAILED : 0;
  }

  /** The only model of one call per case. */
  private TestModel model(Activity activity) {
    List<TestModel> models =
        arguments.modelsOf(activity).stream().filter(m -> m.sequence() == null).toList();
    if (models.size() == 1) {
      return models.get(0).withoutRelations().withoutTiming();
    }
    throw InvalidInputException.of(
        arguments.folder().toString(),
        models.isEmpty()
            ? "has no model of one call per case"
            : "has several models; choose one with --model: "
                + String.join(", ", models.stream().map(TestModel::name).toList()));
  }

  /** Valid cases from the whole suite, without the faults that the model itself sets. */
  private static List<TestCase> chosen(TestSuite suite, TestModel model) {
    List<TestCase> valid = suite.cases().stream().filter(TestCase::valid).toList();
    List<TestCase> withoutFaults =
        valid.stream().filter(testCase -> isWithoutFaults(testCase, model)).toList();
    return spread(withoutFaults.isEmpty() ? valid : withoutFaults, MAX_HEALTHY);
  }

  private static boolean isWithoutFaults(TestCase testCase, TestModel model) {
    return IntStream.range(0, model.inputs().size())
        .allMatch(
            i ->
                FaultName.find(model.inputs().get(i).name())
                    .filter(name -> name.part() == FaultName.Part.FAULT)
                    .map(
                        name ->
                            Double.parseDouble(testCase.values().get(i)) == name.kind().neutral())
                    .orElse(true));
  }

  private static List<Healthy> bases(List<Healthy> passing, TestModel model) {
    if (passing.isEmpty()) {
      throw InvalidInputException.of(
          model.source(), "no valid case passes without faults; see ./sitaf run");
    }
    return spread(passing, MAX_BASES);
  }

  private static <T> List<T> spread(List<T> all, int most) {
    int count = Math.min(most, all.size());
    return IntStream.range(0, count)
        .mapToObj(i -> all.get((int) ((long) i * all.size() / count)))
        .toList();
  }
}
