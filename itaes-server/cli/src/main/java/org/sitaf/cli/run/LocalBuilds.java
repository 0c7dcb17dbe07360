package org.sitaf.cli.run;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.build.OfferedDevices;
import org.sitaf.agent.build.RecordingOrder;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.agent.toolchain.debug.DebugOrder;
import org.sitaf.cli.debug.DebugSession;
import org.sitaf.cli.debug.DebuggedCase;
import org.sitaf.cli.debug.SceneServer;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.terminal.OnExit;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;

/** Runs builds on this machine, with their own simulations; leaves no files. */
public final class LocalBuilds implements AutoCloseable {
  /** Limit for recordings, the same as in a test application. */
  private static final long RECORDED_BYTES = 64L << 20;

  private final Path directory;
  private final BuildSettings settings;
  private final OutputFolders folders;
  private final AtomicInteger count = new AtomicInteger();
  private final AtomicReference<@Nullable BuildRun> current = new AtomicReference<>();
  private @Nullable TestResult finished;
  private final OnExit onExit = new OnExit(this::cancel);

  /**
   * Creates the folder and starts the first simulation.
   *
   * @param withWorld number of builds that need a simulation
   */
  public LocalBuilds(
      Installation installation,
      Sandbox sandbox,
      boolean coverage,
      OutputFolders folders,
      int withWorld)
      throws IOException {
    this(installation, sandbox, coverage, folders, withWorld, Map.of());
  }

  /**
   * Creates the folder and starts the first simulation.
   *
   * @param withWorld number of builds that need a simulation
   * @param devices addresses of the providers of real devices; they replace those of the activity
   */
  public LocalBuilds(
      Installation installation,
      Sandbox sandbox,
      boolean coverage,
      OutputFolders folders,
      int withWorld,
      Map<String, String> devices)
      throws IOException {
    this(
        installation,
        sandbox,
        coverage,
        folders,
        devices,
        directory ->
            Simulator.started(
                installation.bridgeCommand(), directory.resolve("simulator"), sandbox, withWorld));
  }

  private LocalBuilds(
      Installation installation,
      Sandbox sandbox,
      boolean coverage,
      OutputFolders folders,
      Map<String, String> devices,
      Function<Path, Simulator> simulator)
      throws IOException {
    directory = Files.createTempDirectory("sitaf-run-");
    settings =
        new BuildSettings(
                simulator.apply(directory),
                new Toolchains(new ToolchainPlaces(installation.runtimes(), installation.cache())),
                sandbox,
                coverage,
                "")
            // The user of this machine runs an activity of his own choice.
            .offering(new OfferedDevices(devices, true));
    this.folders = folders;
  }

  /**
   * Builds whose simulations run on a bridge that the user started.
   *
   * @param bridge its gRPC target
   */
  public static LocalBuilds onBridge(
      Installation installation, Sandbox sandbox, OutputFolders folders, String bridge)
      throws IOException {
    return new LocalBuilds(
        installation, sandbox, false, folders, Map.of(), directory -> Simulator.running(bridge));
  }

  /** A description of the sandbox, or the reason why there is none. */
  public String sandbox() {
    return settings.sandbox().description();
  }

  /** Generates, compiles and executes a test application; prints the progress to standard error. */
  public BuildOutcome run(Activity activity, TestModel model, TestSuite suite) {
    return run(activity, model, suite, System.err);
  }

  /**
   * Like {@link #run}, with the signals of each case.
   *
   * @param variation of its processes; see {@link org.sitaf.agent.toolchain.ProcessPlace}
   * @param signals receives the signals of the cases, in any thread
   */
  BuildOutcome run(
      Activity activity,
      TestModel model,
      TestSuite suite,
      int variation,
      BiConsumer<Integer, Trace> signals) {
    return run(
        activity,
        model,
        suite,
        System.err,
        settings(model).varied(variation).withSignals(),
        signals);
  }

  /** Like {@link #run}, without repeated calls and without printing the progress. */
  public BuildOutcome runQuietly(Activity activity, TestModel model, TestSuite suite) {
    return run(
        activity.withoutTiming(),
        model.withoutTiming(),
        suite,
        new PrintStream(OutputStream.nullOutputStream(), false, UTF_8));
  }

  /**
   * Runs a test application and hands over what is recorded of each case.
   *
   * @param variation of its processes; see {@link org.sitaf.agent.toolchain.ProcessPlace}
   * @param coverage whether the coverage of the component is measured
   * @param observer receives the records and signals of the cases, in any thread
   */
  public BuildOutcome observe(
      Activity activity,
      TestModel model,
      TestSuite suite,
      int variation,
      boolean coverage,
      CaseObserver observer) {
    settings.toolchains().startAhead(activity.profile().harness(), settings.sandbox());
    return start(
        InterfaceTestApplicationGenerator.generate(activity, model, suite),
        settings.withSignals().withCoverage(coverage).varied(variation),
        observer);
  }

  /**
   * Runs a test application without coverage and hands over what is recorded of each case.
   *
   * @param signals whether the observer receives the signals of the cases
   */
  public BuildOutcome record(
      Activity activity,
      TestModel model,
      TestSuite suite,
      boolean signals,
      BuildListener observer) {
    settings.toolchains().startAhead(activity.profile().harness(), settings.sandbox());
    BuildSettings plain = settings.withCoverage(false);
    return start(
        InterfaceTestApplicationGenerator.generate(activity, model, suite),
        signals ? plain.withSignals() : plain,
        observer);
  }

  /**
   * Runs a test application without coverage and without printing the progress.
   *
   * @param ends receives each result, in any thread; true cancels the build
   */
  public BuildOutcome runUntil(
      Activity activity, TestModel model, TestSuite suite, Predicate<CaseResult> ends) {
    return start(
        InterfaceTestApplicationGenerator.generate(
            activity.withoutTiming(), model.withoutTiming(), suite),
        settings.withCoverage(false),
        (CaseObserver)
            result -> {
              if (ends.test(result)) {
                cancel();
              }
            });
  }

  /**
   * Runs a test application whose first process waits for a debugger; the calls are not repeated.
   *
   * @param folder the user's folder of the activity
   * @param session attaches to the process
   * @param scene shows the case while it runs; null if nobody watches
   * @throws InvalidInputException if this machine lacks the debugger
   */
  BuildOutcome debug(
      Activity activity,
      TestModel model,
      TestSuite suite,
      Path folder,
      DebugSession session,
      @Nullable SceneServer scene)
      throws IOException, InterruptedException {
    settings
        .toolchains()
        .of(activity.profile().harness())
        .flatMap(Toolchain::missingDebugger)
        .ifPresent(
            missing -> {
              throw InvalidInputException.of("--debug", missing);
            });
    DebugOrder order =
        new DebugOrder(
            folder,
            activity.profile().component().className(),
            InterfaceTestApplicationGenerator.methodsUnderTest(activity, model, suite),
            !session.isPrintOnly(),
            session::attach);
    BuildOutcome outcome =
        start(
            InterfaceTestApplicationGenerator.generate(
                activity.withoutTiming(), model.withoutTiming(), suite),
            (scene == null ? settings(model) : watched(model)).debugged(order),
            new DebuggedCase(new SignalFolder(folders.signalsOf(model))::write, scene));
    if (!(outcome instanceof BuildOutcome.Cancelled)) {
      session.awaitEnd();
    }
    return outcome;
  }

  /**
   * The result of a build.
   *
   * @throws InvalidInputException if the build failed; contains the reason
   * @throws InterruptedException if it was cancelled
   */
  public TestResult completed(Activity activity, BuildOutcome outcome) throws InterruptedException {
    if (outcome instanceof BuildOutcome.Cancelled cancelled) {
      throw new InterruptedException(cancelled.reason());
    }
    if (outcome instanceof BuildOutcome.CompilationFailed failed) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  failed.diagnostics().isEmpty() ? "" : failed.diagnostics().get(0).file(),
                  failed.diagnostics().isEmpty() ? 0 : failed.diagnostics().get(0).line(),
                  "",
                  failed.diagnostics().isEmpty()
                      ? failed.message()
                      : failed.message() + ": " + failed.diagnostics().get(0).message())));
    }
    if (outcome instanceof BuildOutcome.InfrastructureFailed failed) {
      throw InvalidInputException.of(activity.profile().name(), failed.message());
    }
    return ((BuildOutcome.Completed) outcome).result();
  }

  private BuildOutcome run(
      Activity activity, TestModel model, TestSuite suite, PrintStream messages) {
    return run(activity, model, suite, messages, settings(model), (no, trace) -> {});
  }

  private BuildOutcome run(
      Activity activity,
      TestModel model,
      TestSuite suite,
      PrintStream messages,
      BuildSettings with,
      BiConsumer<Integer, Trace> signals) {
    // Starts a compiler while the simulation starts.
    settings.toolchains().startAhead(activity.profile().harness(), settings.sandbox());
    try (ProgressLine progress = new ProgressLine(messages)) {
      progress.step(model.name() + ": generating the test application");
      TestApplication application =
          InterfaceTestApplicationGenerator.generate(activity, model, suite);
      return start(
          application,
          with,
          new BuildProgress(
              model.name(),
              suite.cases().size(),
              progress,
              new SignalFolder(folders.signalsOf(model)),
              signals));
    }
  }

  private BuildOutcome start(
      TestApplication application, BuildSettings settings, BuildListener listener) {
    BuildRun run =
        new BuildRun(
            application, directory.resolve("build-" + count.incrementAndGet()), settings, listener);
    current.set(run);
    BuildOutcome outcome = run.run();
    finished =
        outcome instanceof BuildOutcome.Cancelled ? run.finished("interrupted").orElse(null) : null;
    return outcome;
  }

  /** The finished cases of the last build if it was cancelled while its cases ran. */
  Optional<TestResult> finishedOfCancelled() {
    return Optional.ofNullable(finished);
  }

  /** A folder for files that are deleted with the builds. */
  public Path folder(String name) throws IOException {
    return Files.createDirectories(directory.resolve(name));
  }

  private BuildSettings settings(TestModel model) {
    Path recordings = folders.recordings();
    return recordings == null ? sampled() : recorded(recordings.resolve(model.name()));
  }

  /** Only what is recorded can be watched. */
  private BuildSettings watched(TestModel model) throws IOException {
    return folders.recordings() == null ? recorded(folder("watched")) : settings(model);
  }

  private BuildSettings sampled() {
    return folders.signals() == null ? settings : settings.withSignals();
  }

  private BuildSettings recorded(Path folder) {
    return sampled()
        .recording(
            new RecordingOrder(
                folder, RecordingOrder.Cases.ALL, Integer.MAX_VALUE, RECORDED_BYTES));
  }

  private void cancel() {
    BuildRun run = current.get();
    if (run != null) {
      run.cancel("the command was interrupted");
    }
  }

  @Override
  public void close() {
    try (onExit) {
      settings.toolchains().stop();
      settings.simulator().close();
      delete();
    }
  }

  private void delete() {
    try {
      Folders.delete(directory);
    } catch (IOException e) {
      throw new UncheckedIOException("cannot delete " + directory, e);
    }
  }

  /**
   * Where the files of cases are written.
   *
   * @param recordings folder of recordings; null for none
   * @param signals folder of signals; null for none
   * @param severalModels whether each model has its own folder of signals
   */
  public record OutputFolders(
      @Nullable Path recordings, @Nullable Path signals, boolean severalModels) {
    @Nullable Path signalsOf(TestModel model) {
      return signals == null || !severalModels ? signals : signals.resolve(model.name());
    }
  }

  /** Receives what is recorded of each case. */
  public interface CaseObserver extends BuildListener {
    @Override
    default void stage(BuildStage stage) {
      // The command shows its own progress.
    }

    @Override
    default void log(byte[] utf8) {
      // The output of a component is not printed.
    }

    @Override
    default void recorded(int no, Path recording) {
      // Nothing is recorded.
    }
  }
}
