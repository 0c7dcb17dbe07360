package org.sitaf.cli.bisect;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.bisect.Criterion.Decision;
import org.sitaf.cli.bisect.VersionTests.Tested;
import org.sitaf.cli.compare.Version;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.SuiteCache;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.git.FolderHistory;
import org.sitaf.cli.git.FolderHistory.Commit;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.option.SeedOption;
import org.sitaf.cli.run.CaseOptions;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.bisect.Bisection;
import org.sitaf.core.bisect.Bisection.Outcome;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestSuite;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Finds the commit that broke a component. */
@Command(
    name = "bisect",
    description = {
      "Finds the first commit after GOOD whose component behaves as badly as that of BAD: cases of"
          + " BAD's models fail or, if none fails, give other values than with GOOD.",
      "Exit code 0: one commit is found; 1: several remain, since others cannot be tested; 2: the"
          + " search is not possible."
    },
    mixinStandardHelpOptions = true)
public final class BisectCommand implements Callable<Integer> {
  private static final int SEVERAL = 1;

  @Spec private @Nullable CommandSpec spec;

  @Parameters(
      index = "0",
      paramLabel = "FOLDER",
      description = "The folder of the activity in a Git repository.")
  private Path folder = Path.of("");

  @Parameters(index = "1", paramLabel = "GOOD", description = "A revision that is good.")
  private String good = "";

  @Parameters(index = "2", paramLabel = "BAD", description = "A later revision that is bad.")
  private String bad = "";

  @Option(
      names = "--model",
      paramLabel = "NAME",
      description = "The test model of BAD; default: all its models.")
  private @Nullable String model;

  @Option(
      names = "--case",
      paramLabel = "NUMBERS",
      converter = CaseOptions.NumbersConverter.class,
      description = "Only these cases decide, such as 9,12-20.")
  private @Nullable CaseNumbers numbers;

  @Option(
      names = "--values",
      description = "Differences from the values of GOOD decide, even if cases fail.")
  private boolean values;

  @Option(names = "--json", paramLabel = "FILE", description = "Also writes the result as JSON.")
  private @Nullable Path json;

  @Mixin private final SeedOption seed = new SeedOption();

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  private final Map<String, Tested> known = new HashMap<>();
  private final Map<String, Decision> decisions = new LinkedHashMap<>();

  /** Searches the history. */
  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    if (json != null) {
      UserFiles.requireWritableFile("--json", json);
    }
    FolderHistory history = FolderHistory.read(folder, good, bad);
    Version last = version("BAD", bad);
    Sitaf.print(last.activity().warnings(), err);
    Map<TestModel, TestSuite> suites = suites(last);
    int withWorld =
        last.activity().profile().world() == null ? 0 : suites.size() * expectedBuilds(history);
    try (LocalBuilds builds =
            new LocalBuilds(
                Installation.current(),
                sandbox.open(),
                false,
                new LocalBuilds.OutputFolders(null, null, false),
                withWorld);
        ProgressLine progress = new ProgressLine(System.err)) {
      err.println("sandbox: " + builds.sandbox());
      err.println(history.commits().size() + " commits change the folder after " + good);
      err.flush();
      VersionTests tests = new VersionTests(builds, last, suites);
      Criterion criterion = criterion(history, last, suites, tests, progress);
      err.println("bad is a commit that " + criterion.text());
      err.flush();
      Bisection bisection = search(history, criterion, tests, progress, err);
      if (criterion instanceof FailingCases failing && !bisection.hasGood()) {
        FailingCases narrowed = withoutFailuresOfGood(failing, history, tests, progress);
        if (!narrowed.equals(failing)) {
          err.println(
              "GOOD fails in the other cases, too; bad is a commit that " + narrowed.text());
          err.flush();
          bisection = search(history, narrowed, tests, progress, err);
        }
      }
      return report(history, bisection, tests.count(), out);
    }
  }

  /** Executes the bad version and, if no case fails, the good one. */
  private Criterion criterion(
      FolderHistory history,
      Version last,
      Map<TestModel, TestSuite> suites,
      VersionTests tests,
      ProgressLine progress)
      throws IOException, InterruptedException {
    progress.step("testing BAD");
    Tested ofBad = usable("BAD", tests.test(last));
    FailingCases failing = new FailingCases(ofBad.failing());
    if (!values && !failing.isEmpty()) {
      VersionTests.deleteSignals(ofBad);
      return failing;
    }
    progress.step("testing GOOD");
    Tested ofGood = usable("GOOD", tests.test(version("GOOD", history.good())));
    OtherValues different = OtherValues.between(last.activity(), suites, ofGood, ofBad);
    if (different.isEmpty()) {
      throw InvalidInputException.of(
          "BAD",
          (failing.isEmpty() ? "no case fails, and GOOD" : "GOOD")
              + " gives the same values; choose other cases or revisions");
    }
    VersionTests.deleteSignals(ofBad);
    return different;
  }

  private static Tested usable(String label, Tested tested) {
    if (!tested.problem().isEmpty()) {
      throw InvalidInputException.of(label, "cannot be tested: " + tested.problem());
    }
    return tested;
  }

  private static int expectedBuilds(FolderHistory history) {
    return 2 + Integer.SIZE - Integer.numberOfLeadingZeros(history.commits().size());
  }

  private Version version(String label, String revision) throws IOException {
    return Version.read(label, folder + "@" + revision);
  }

  private Map<TestModel, TestSuite> suites(Version last) {
    List<TestModel> models = last.activity().models();
    String wanted = model;
    if (wanted != null) {
      models =
          List.of(
              last.activity()
                  .model(wanted)
                  .orElseThrow(
                      () ->
                          InvalidInputException.of("--model " + wanted, "does not exist in BAD")));
    }
    if (models.isEmpty()) {
      throw InvalidInputException.of(bad, "names no test model in activity.yaml");
    }
    CaseNumbers only = numbers;
    if (only != null && models.size() > 1) {
      throw InvalidInputException.of("--case", "needs --model, since BAD has several models");
    }
    Map<TestModel, TestSuite> suites = new LinkedHashMap<>();
    for (TestModel each : models) {
      TestSuite suite =
          new SuiteCache(Installation.current().state().resolve("suites"))
              .generate(each, GenerationOptions.DEFAULT.withSeed(seed.value()))
              .suite();
      suites.put(each, only == null ? suite : only.select(suite));
    }
    return suites;
  }

  /** Versions that are known from an earlier search are not executed again. */
  private Bisection search(
      FolderHistory history,
      Criterion criterion,
      VersionTests tests,
      ProgressLine progress,
      PrintWriter err)
      throws IOException, InterruptedException {
    Bisection bisection = new Bisection(history.commits().stream().map(Commit::parents).toList());
    for (OptionalInt next = bisection.next(); next.isPresent(); next = bisection.next()) {
      Commit commit = history.commits().get(next.getAsInt());
      int left = bisection.candidates().size();
      Tested tested = known.get(commit.id());
      if (tested == null) {
        progress.step("testing %s, 1 of %d commits".formatted(commit.shortId(), left));
        tested = test(commit, tests);
        known.put(commit.id(), tested);
      }
      Decision decision = criterion.decide(tested);
      decisions.put(commit.id(), decision);
      bisection.record(next.getAsInt(), decision.outcome());
      VersionTests.deleteSignals(tested);
      err.println(
          Printable.line(
              "%s %s: %s%s"
                  .formatted(
                      commit.shortId(),
                      word(decision.outcome()),
                      commit.subject(),
                      decision.outcome() == Outcome.SKIPPED
                          ? " (" + decision.reason() + ")"
                          : "")));
      err.flush();
    }
    return bisection;
  }

  private static String word(Outcome outcome) {
    return switch (outcome) {
      case GOOD -> "good";
      case BAD -> "bad";
      case SKIPPED -> "cannot be tested";
    };
  }

  /** A version whose documents are invalid cannot be tested. */
  private Tested test(Commit commit, VersionTests tests) throws IOException, InterruptedException {
    Version version;
    try {
      version = version(commit.shortId(), commit.id());
    } catch (InvalidInputException e) {
      return Tested.impossible(String.valueOf(e.getMessage()));
    }
    return tests.test(version);
  }

  /** No commit was good, so the cases may fail with GOOD, too; those do not decide. */
  private FailingCases withoutFailuresOfGood(
      FailingCases failing, FolderHistory history, VersionTests tests, ProgressLine progress)
      throws IOException, InterruptedException {
    progress.step("testing GOOD");
    Tested ofGood = tests.test(version("GOOD", history.good()));
    Decision decision = failing.decide(ofGood);
    FailingCases narrowed = failing.without(ofGood);
    if (decision.outcome() == Outcome.SKIPPED || narrowed.isEmpty()) {
      throw InvalidInputException.of(
          "GOOD",
          (decision.outcome() == Outcome.BAD ? "is bad, too: " : "cannot be tested: ")
              + decision.reason()
              + "; name an earlier revision");
    }
    return narrowed;
  }

  private int report(FolderHistory history, Bisection bisection, int builds, PrintWriter out)
      throws IOException {
    List<Commit> candidates = bisection.candidates().stream().map(history.commits()::get).toList();
    if (json != null) {
      List<BisectionJson.TestedCommit> tested =
          decisions.entrySet().stream()
              .map(e -> new BisectionJson.TestedCommit(e.getKey(), e.getValue()))
              .toList();
      Files.writeString(json, BisectionJson.write(candidates, tested, builds));
    }
    out.println(
        candidates.size() == 1
            ? "first bad commit:"
            : "one of these commits is the first bad one; the others cannot be tested:");
    for (Commit commit : candidates) {
      out.println(
          Printable.line(
              "  %s %s %s: %s"
                  .formatted(commit.id(), commit.time(), commit.author(), commit.subject())));
    }
    Decision first = decisions.get(candidates.get(0).id());
    if (candidates.size() == 1 && first != null) {
      out.println(Printable.line("  " + first.reason()));
    }
    out.println(builds + " versions tested");
    out.flush();
    return candidates.size() == 1 ? 0 : SEVERAL;
  }
}
