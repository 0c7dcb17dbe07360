package org.sitaf.cli.run;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.debug.DebugOptions;
import org.sitaf.cli.debug.DebugSession;
import org.sitaf.cli.debug.SceneServer;
import org.sitaf.cli.debug.WatchedCase;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.SuiteCache;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.ActivityArguments;
import org.sitaf.cli.option.GenerationArguments;
import org.sitaf.cli.option.RosOption;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.system.DeviceOptions;
import org.sitaf.cli.system.RemoteRun;
import org.sitaf.cli.terminal.OnExit;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.flaky.FlakyCase;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.JunitXml;
import org.sitaf.core.verdict.document.TestResultXml;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Tests an activity on this machine or on a server's agents. */
@Command(
    name = "run",
    description = {
      "Tests one activity: generates test cases and test application, compiles and executes them.",
      "Exit code 0: every case passed; 1: a case is FAIL or ERROR, or the result is suspect; 2:"
          + " no case failed, but a case is DONT (not executed) or nothing ran."
    },
    mixinStandardHelpOptions = true)
public final class RunCommand implements Callable<Integer> {
  private static final int TEST_FAILED = 1;
  private static final int MAX_ROWS = 100;

  /** The build and the further runs that a server accepts. */
  private static final int MAX_REMOTE_RUNS = 101;

  @Spec private @Nullable CommandSpec spec;

  @Mixin private final ActivityArguments arguments = new ActivityArguments();

  @Option(
      names = "--junit",
      paramLabel = "FILE",
      description = "Also writes the results as JUnit XML.")
  private @Nullable Path junit;

  @Option(
      names = "--result",
      paramLabel = "FILE",
      description =
          "Also writes the test result descriptor; without --model a folder with one file per"
              + " model.")
  private @Nullable Path resultFile;

  @Mixin private final GenerationArguments generation = new GenerationArguments();

  @Mixin private final CaseOptions cases = new CaseOptions();

  @Mixin private final DebugOptions debugging = new DebugOptions();

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  @Mixin private final RosOption ros = new RosOption();

  @Option(
      names = "--no-coverage",
      description = "Does not measure the line coverage of the component.")
  private boolean noCoverage;

  @Option(
      names = "--recording",
      paramLabel = "FOLDER",
      description = "Records the motion in each case: FOLDER/MODEL/NO.glb, for any glTF viewer.")
  private @Nullable Path recording;

  @Option(
      names = "--signals",
      paramLabel = "FOLDER",
      description =
          "Writes the signals of each case as FOLDER/NO.csv; without --model and with several"
              + " models as FOLDER/MODEL/NO.csv.")
  private @Nullable Path signals;

  @Mixin private final RemoteOptions remote = new RemoteOptions();

  @Mixin private final DeviceOptions devices = new DeviceOptions();

  @Option(names = "--table", description = "Prints all cases, not only those that did not pass.")
  private boolean table;

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    requireWritable();
    remote.check(spec);
    if (remote.isRemote()) {
      devices.requireNone(spec);
    }
    debugging.check(spec, remote.isRemote(), cases.areRepeated(), sandbox.isRequired());
    if (debugging.debug && ros.implementation() != RosImplementation.INCLUDED) {
      throw new CommandLine.ParameterException(
          spec.commandLine(), "--debug is not available with --ros system");
    }
    if (remote.isRemote() && generation.changesModel()) {
      throw new CommandLine.ParameterException(
          spec.commandLine(),
          "--strength, --max-cases and --effort are not available with --server; set"
              + " order_of_combinations and max_cases in the model");
    }
    if (remote.isRemote() && (cases.untilFailure || cases.runs() > MAX_REMOTE_RUNS)) {
      throw new CommandLine.ParameterException(
          spec.commandLine(),
          cases.untilFailure
              ? "--until-failure is not available with --server; use --repeat"
              : "--repeat must be at most " + MAX_REMOTE_RUNS + " with --server");
    }
    FileTree files = UserFiles.folder(arguments.folder());
    Activity activity = Installation.read(files).with(ros.implementation());
    Sitaf.print(activity.warnings(), err);
    List<TestResult> results = new ArrayList<>();
    // An interrupted run still writes the cases that ended.
    try (OnExit onExit = new OnExit(() -> {})) {
      int exitCode =
          remote.isRemote()
              ? runRemotely(files, activity, results, out, err)
              : runHere(activity, results, out, err);
      write(activity, results);
      return exitCode;
    }
  }

  private int runRemotely(
      FileTree files, Activity activity, List<TestResult> results, PrintWriter out, PrintWriter err)
      throws IOException, InterruptedException {
    LastResults last = lastResults();
    CaseSelection selection = new CaseSelection(cases, last, arguments.folder());
    List<TestModel> models = selection.models(arguments.modelsOf(activity));
    int exitCode = 0;
    try (OnExit onExit = new OnExit(Thread.currentThread()::interrupt)) {
      RemoteRun run = remote.upload(arguments.folder(), files, activity, System.err);
      for (TestModel model : models) {
        try {
          Optional<RemoteRun.Ended> ended =
              run.test(
                  model.name(),
                  generation.seed(),
                  suite -> selection.of(model, suite),
                  cases.runs());
          if (ended.isEmpty()) {
            reportNothingToRun(model, err);
            continue;
          }
          TestResult result = ended.get().result();
          print(result, out);
          RepeatedBuilds.print(cases.runs(), ended.get().flaky(), out);
          last.keep(arguments.folder(), model, result, ended.get().whole());
          results.add(result);
          exitCode = worse(exitCode, exitCode(result));
          if (ended.get().flaky().stream().anyMatch(FlakyCase::failed)) {
            exitCode = TEST_FAILED;
          }
        } catch (InvalidInputException e) {
          Sitaf.print(e.diagnostics(), err);
          exitCode = worse(exitCode, Sitaf.UNUSABLE);
        }
      }
    }
    return exitCode;
  }

  private int runHere(Activity activity, List<TestResult> results, PrintWriter out, PrintWriter err)
      throws IOException, InterruptedException {
    int exitCode = 0;
    Path state = Installation.current().state();
    LastResults last = lastResults();
    CaseSelection selection = new CaseSelection(cases, last, arguments.folder());
    List<TestModel> models = selection.models(arguments.modelsOf(activity));
    if (debugging.debug) {
      debugging.only(activity, models);
    }
    SuiteCache suites = new SuiteCache(state.resolve("suites"));
    int withWorld =
        activity.profile().world() == null
            ? 0
            : (int) Math.min(1_000, (long) models.size() * cases.runs());
    try (LocalBuilds builds =
        new LocalBuilds(
            Installation.current(),
            sandbox.open(),
            !noCoverage,
            new LocalBuilds.OutputFolders(recording, signals, models.size() > 1),
            withWorld,
            devices.addresses(spec, activity))) {
      err.println("sandbox: " + builds.sandbox());
      err.flush();
      RepeatedBuilds repeated = new RepeatedBuilds(builds, cases, err);
      for (TestModel model : models) {
        GeneratedSuite generated = suites.generate(model, generation.options());
        Sitaf.print(generated.notes(), err);
        TestSuite selected = selection.of(model, generated.suite());
        if (selected.cases().isEmpty() && !generated.suite().cases().isEmpty()) {
          reportNothingToRun(model, err);
          continue;
        }
        if (debugging.debug) {
          DebugOptions.requireOneCase(model, selected);
          return debug(builds, activity, model, selected, results, out, err);
        }
        RepeatedBuilds.Ended ended = repeated.run(activity, model, selected);
        Optional<TestResult> result = ended.result();
        if (result.isPresent()) {
          ended.warnings().forEach(w -> err.println(Printable.lines(w, "  ")));
          err.flush();
          print(result.get(), out);
          RepeatedBuilds.print(ended.runs().count(), ended.flaky(), out);
          results.add(result.get());
          last.keep(arguments.folder(), model, result.get(), selected == generated.suite());
          exitCode = worse(exitCode, exitCode(result.get()));
        }
        if (!(ended.last() instanceof BuildOutcome.Completed)) {
          print(ended.last(), err);
          exitCode = worse(exitCode, Sitaf.UNUSABLE);
        }
        if (ended.last() instanceof BuildOutcome.Cancelled) {
          break;
        }
      }
    }
    return exitCode;
  }

  private static LastResults lastResults() {
    return new LastResults(Installation.current().state().resolve("results"));
  }

  private static void reportNothingToRun(TestModel model, PrintWriter err) {
    err.println(model.name() + ": nothing to run, every case passed");
    err.flush();
  }

  private int debug(
      LocalBuilds builds,
      Activity activity,
      TestModel model,
      TestSuite suite,
      List<TestResult> results,
      PrintWriter out,
      PrintWriter err)
      throws IOException, InterruptedException {
    err.println(
        model.name()
            + ": debugging case "
            + suite.cases().get(0).no()
            + "; the component runs without a sandbox");
    err.flush();
    BuildOutcome outcome;
    try (SceneServer scene =
            debugging.view
                ? new SceneServer(
                    WatchedCase.of(activity.profile().name(), model, suite.cases().get(0)))
                : null;
        DebugSession session = new DebugSession(debugging.printCommand, err)) {
      if (scene != null) {
        err.println("scene: " + scene.address());
        err.flush();
      }
      outcome = builds.debug(activity, model, suite, arguments.folder(), session, scene);
    }
    if (!(outcome instanceof BuildOutcome.Completed completed)) {
      print(outcome, err);
      return Sitaf.UNUSABLE;
    }
    print(completed.result(), out);
    out.println("the processing time includes the time in the debugger");
    out.flush();
    results.add(completed.result());
    return exitCode(completed.result());
  }

  private void print(TestResult result, PrintWriter out) {
    if (table && !result.cases().isEmpty()) {
      ResultTable.printAll(result, out);
    }
    ResultTable.printFailures(result, table ? 0 : MAX_ROWS, out);
    ResultTable.printSummary(result, out);
  }

  private static void print(BuildOutcome outcome, PrintWriter err) {
    if (outcome instanceof BuildOutcome.CompilationFailed failed) {
      failed.diagnostics().forEach(d -> err.println(Printable.lines(d.toString(), "  ")));
      err.println("sitaf: " + Printable.lines(failed.message(), "  "));
    } else if (outcome instanceof BuildOutcome.InfrastructureFailed failed) {
      err.println("sitaf: " + Printable.lines(failed.message(), "  "));
    } else if (outcome instanceof BuildOutcome.Cancelled cancelled) {
      err.println("sitaf: cancelled: " + cancelled.reason());
    }
    err.flush();
  }

  /** The exit code for one result. */
  static int exitCode(TestResult result) {
    if (result.summary().fail() + result.summary().error() > 0) {
      return TEST_FAILED;
    }
    if (result.summary().dont() > 0 || result.summary().total() == 0) {
      return Sitaf.UNUSABLE;
    }
    return result.allPassed() ? 0 : TEST_FAILED;
  }

  /** The worse of two exit codes: 1 (failed) is worse than 2 (not executed). */
  static int worse(int one, int other) {
    return one == TEST_FAILED || other == TEST_FAILED ? TEST_FAILED : Math.max(one, other);
  }

  /**
   * Checks before the run that the results can be written.
   *
   * @throws InvalidInputException if a file or folder of an option cannot be written
   */
  private void requireWritable() {
    if (junit != null) {
      UserFiles.requireWritableFile("--junit", junit);
    }
    if (resultFile != null && arguments.namesModel()) {
      UserFiles.requireWritableFile("--result", resultFile);
    } else if (resultFile != null) {
      UserFiles.requireWritableFolder("--result", resultFile);
    }
    if (recording != null) {
      UserFiles.requireWritableFolder("--recording", recording);
    }
    if (signals != null) {
      UserFiles.requireWritableFolder("--signals", signals);
    }
  }

  private void write(Activity activity, List<TestResult> results) throws IOException {
    if (junit != null) {
      try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(junit))) {
        JunitXml.write(activity.profile().name(), results, out);
      }
    }
    if (resultFile != null) {
      for (TestResult result : results) {
        Path file = resultFile;
        if (!arguments.namesModel()) {
          Files.createDirectories(resultFile);
          file = resultFile.resolve(result.name() + ".xml");
        }
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
          TestResultXml.write(result, out);
        }
      }
    }
  }
}
