package org.sitaf.agent.build;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.compiler.TestApplicationCompiler;
import org.sitaf.agent.executor.EarlyProcess;
import org.sitaf.agent.executor.Execution;
import org.sitaf.agent.executor.ExecutionRequest;
import org.sitaf.agent.executor.ParallelExecutor;
import org.sitaf.agent.executor.TestApplicationExecutor;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.FreeSpace;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.TestResult;

/**
 * One build of a test application without a server; used by agents and by the command line. Runs
 * once, in its own thread, for which {@link #run()} waits.
 */
public final class BuildRun {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");

  private final TestApplication whole;
  private final TestApplication application;
  private final Path directory;
  private final BuildSettings settings;
  private final BuildListener listener;
  private final Consumer<CaseRecord> records;
  private final Cancellation cancellation = new Cancellation();
  private final List<CaseResult> finished = Collections.synchronizedList(new ArrayList<>());
  private volatile @Nullable Function<Execution, TestResult> reporter;

  /**
   * Creates a build.
   *
   * @param directory for the build's files, such as {@link #LOG}; created if missing, deleted by
   *     the caller
   */
  public BuildRun(
      TestApplication application, Path directory, BuildSettings settings, BuildListener listener) {
    this(application, directory, settings, listener, record -> {});
  }

  /**
   * Creates a build.
   *
   * @param records receives the record of each case, in any thread
   */
  BuildRun(
      TestApplication application,
      Path directory,
      BuildSettings settings,
      BuildListener listener,
      Consumer<CaseRecord> records) {
    this.records = records;
    this.application = application.withoutReferenceFiles();
    this.whole = application;
    this.directory = directory.toAbsolutePath().normalize();
    this.settings = settings;
    this.listener = listener;
  }

  /** File name of the log in a build's folder. */
  public static final String LOG = "build.log";

  /** Subfolder that test applications write to; may exist before the build. */
  public static final String WRITTEN = "execution";

  /** Cancels the build in any stage; may be called from any thread, also before the start. */
  public void cancel(String reason) {
    cancellation.request(reason);
  }

  /** Runs all stages and returns the outcome; never throws. */
  public BuildOutcome run() {
    return new BuildThread(cancellation, this::work).run(limit().all());
  }

  /**
   * The result of a build that was cancelled while its cases ran: the finished cases; the others
   * are DONT for the given reason. Empty if no case was started.
   */
  public Optional<TestResult> finished(String reason) {
    Function<Execution, TestResult> known = reporter;
    return known == null
        ? Optional.empty()
        : Optional.of(known.apply(new Execution(copy(finished), reason, List.of())));
  }

  private static List<CaseResult> copy(List<CaseResult> results) {
    synchronized (results) {
      return List.copyOf(results);
    }
  }

  private TimeLimit limit() {
    int runs =
        1
            + application.model().relations().size()
            + (application.activity().profile().reference() == null ? 0 : 1);
    return TimeLimit.of(runs * application.suite().cases().size(), limits(), settings.atMost());
  }

  /** The limits of the activity; someone who debugs a case may take any time. */
  private Limits limits() {
    Limits limits = application.activity().limits();
    return settings.debugging() == null
        ? limits
        : limits.withCaseWall(BuildSettings.DEBUGGING_LIMIT);
  }

  private BuildOutcome work() {
    try {
      Files.createDirectories(directory);
      try (BuildLog log = new BuildLog(directory.resolve(LOG), listener)) {
        BuildOutcome outcome = cancellation.guard(() -> stages(log));
        remarkOn(outcome, log);
        return outcome;
      }
    } catch (IOException | UncheckedIOException e) {
      return new BuildOutcome.InfrastructureFailed("the build's folder cannot be used: " + e);
    }
  }

  /**
   * The stages of a test build agent after the download: match, prepare, compile, execute, report.
   */
  BuildOutcome stages(BuildLog log) throws InterruptedException {
    try {
      Instant started = Instant.now();
      match();
      log.remark(settings.sandbox().description());
      TestSuite suite = suite(log);

      listener.stage(BuildStage.PREPARING);
      try (Preparation.Prepared prepared = preparation().run(log)) {
        return compileAndRun(prepared, suite, started, log);
      }
    } catch (CompilationException e) {
      String full = FreeSpace.ofBuild(directory).whyFull();
      return full.isEmpty()
          ? new BuildOutcome.CompilationFailed(String.valueOf(e.getMessage()), e.diagnostics())
          : new BuildOutcome.InfrastructureFailed(full + ": " + e.getMessage());
    } catch (InvalidInputException e) {
      return new BuildOutcome.CompilationFailed(
          "the test application is not valid",
          e.diagnostics().stream()
              .map(d -> new SourceDiagnostic(d.file(), d.line(), 0, d.message(), false))
              .toList());
    } catch (IOException | UncheckedIOException e) {
      return new BuildOutcome.InfrastructureFailed(String.valueOf(e.getMessage()));
    } catch (CancellationException e) {
      // A cancelled evaluation of a post-condition throws its own exception.
      throw new InterruptedException(e.getMessage());
    } catch (RuntimeException e) {
      LOGGER.log(System.Logger.Level.ERROR, "internal error in a build", e);
      return new BuildOutcome.InfrastructureFailed("internal error: " + e);
    }
  }

  /** The suite with its expected values, for which the reference is executed if there is one. */
  private TestSuite suite(BuildLog log)
      throws CompilationException, IOException, InterruptedException {
    if (application.activity().profile().reference() == null) {
      return application.suite();
    }
    listener.stage(BuildStage.PREPARING);
    return new ReferenceRun(whole, directory.resolve("reference"), settings).suite(log);
  }

  private BuildOutcome compileAndRun(
      Preparation.Prepared prepared, TestSuite suite, Instant started, BuildLog log)
      throws CompilationException, IOException, InterruptedException {
    listener.stage(BuildStage.COMPILING);
    Toolchain toolchain = toolchain(application.activity().profile().harness());
    log.remark("toolchain: " + toolchain.version());
    TestApplicationCompiler compiler =
        new TestApplicationCompiler(
            toolchain,
            settings.toolchains().compiled(),
            settings.coverage(),
            settings.debugging() != null,
            settings.sandbox());
    Compilation compilation =
        compiler
            .begin(application, applicationDirectory(), directory.resolve("compilation"))
            .reporting(
                text -> {
                  log.remark(text);
                  listener.progress(text);
                });
    try (EarlyProcess early = startEarly(toolchain, compilation, prepared, log)) {
      CompiledApplication compiled = compiler.compile(compilation);

      List<String> warnings = compiled.warnings();
      warnings.forEach(log::remark);

      listener.stage(BuildStage.RUNNING);
      UsedTools used =
          new UsedTools(toolchain.compiler(application.activity().profile()), compiled.packages());
      CaseSignals signals = prepared.signals();
      ExecutionRequest request = request(compiled, prepared);
      RelationRuns.Executed relations =
          new RelationRuns(application, executor(), signals, settings.recordings())
              .execute(request, prepared.simulator(), log);
      ResultAssembler assembler =
          new ResultAssembler(
              application.model(),
              suite,
              application.activity().recorded(),
              signals.conditions(),
              relations.runs());
      reporter =
          ended ->
              report(ended, relations.suspicions(), assembler, prepared.bridge(), used, started);
      Execution execution =
          execute(
              request,
              early,
              record ->
                  prepared
                      .hardware()
                      .judged(
                          assembler,
                          signals.judge(assembler, record, prepared.simulator()),
                          prepared.simulator()),
              relations.recordings(),
              log);
      signals.report(log);

      TestResult result =
          report(execution, relations.suspicions(), assembler, prepared.bridge(), used, started);
      return new BuildOutcome.Completed(withCoverage(result, compiled, request, log), warnings);
    }
  }

  /** Checks that this machine can run the build. */
  private void match() throws IOException {
    ActivityProfile profile = application.activity().profile();
    for (Language language : List.of(profile.component().language(), profile.harness())) {
      toolchain(language);
    }
  }

  private Toolchain toolchain(Language language) throws IOException {
    return settings
        .toolchains()
        .of(language)
        .orElseThrow(() -> new IOException(settings.toolchains().missingMessage(language)));
  }

  /**
   * Starts the first process during the compilation if the toolchain supports it; null otherwise,
   * if the cases run in several processes or after those of a relation, and if they are debugged.
   */
  private @Nullable EarlyProcess startEarly(
      Toolchain toolchain, Compilation compilation, Preparation.Prepared prepared, BuildLog log)
      throws CompilationException, IOException, InterruptedException {
    if (settings.debugging() != null
        || application.suite().cases().isEmpty()
        || !application.model().relations().isEmpty()
        || !executor().isInSequence(application.suite())) {
      return null;
    }
    Optional<CompiledApplication> opened = toolchain.openEarly(compilation);
    return opened.isEmpty() ? null : EarlyProcess.start(request(opened.get(), prepared), log);
  }

  private ParallelExecutor executor() {
    TestApplicationExecutor each = TestApplicationExecutor.DEFAULT.within(limit().cases());
    return new ParallelExecutor(
        settings.debugging() == null ? each : each.startingWithin(BuildSettings.DEBUGGING_LIMIT),
        sessions());
  }

  private Preparation preparation() {
    return new Preparation(application, applicationDirectory(), settings, listener);
  }

  private ExecutionRequest request(CompiledApplication compiled, Preparation.Prepared prepared)
      throws IOException {
    Path execution = Files.createDirectories(directory.resolve(WRITTEN));
    return new ExecutionRequest(
        compiled,
        settings.debugging() == null ? settings.sandbox() : Sandbox.none(),
        applicationDirectory(),
        application.suite(),
        preparation().suiteFile(),
        execution,
        execution.resolve("coverage"),
        settings.recordings() == null || prepared.world() == null
            ? null
            : execution.resolve("recording"),
        prepared.world(),
        application.timing(),
        limits(),
        settings.variation(),
        settings.debugging());
  }

  private Execution execute(
      ExecutionRequest request,
      @Nullable EarlyProcess early,
      Function<CaseRecord, CaseResult> judge,
      List<Path> secondRuns,
      BuildLog log)
      throws IOException, InterruptedException {
    Path recording = request.recording();
    RecordingOrder order = settings.recordings();
    if (recording == null || order == null) {
      return executor().execute(request, early, log, record -> judged(record, judge));
    }
    Map<Integer, Path> folders = executor().recordingFolders(application.suite(), recording);
    Path collected = recording.resolveSibling("recording.collected");
    try (Recordings recordings =
        new Recordings(folders, collected, secondRuns, order, listener, log)) {
      return executor()
          .execute(
              request,
              early,
              log,
              record -> {
                CaseResult judged = judged(record, judge);
                recordings.expect(judged);
                return judged;
              });
    }
  }

  /**
   * Number of simulations in which cases run in parallel. A component that lives as long as the
   * suite needs a single one.
   */
  private int sessions() {
    ActivityProfile profile = application.activity().profile();
    return profile.parallel() && profile.component().lifeCycle() == LifeCycle.CASE
        ? Runtime.getRuntime().availableProcessors()
        : 1;
  }

  /** Adds the coverage of the component; a failing coverage tool does not fail the build. */
  private TestResult withCoverage(
      TestResult result, CompiledApplication compiled, ExecutionRequest request, BuildLog log)
      throws InterruptedException {
    if (!compiled.recordsCoverage()) {
      return result;
    }
    try {
      return compiled.coverage(request.coverage()).map(result::with).orElse(result);
    } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError e) {
      // The component can write to that folder, too; its files must not affect the verdicts.
      log.conclude("the coverage of the component is unknown: " + e);
      return result;
    }
  }

  private CaseResult judged(CaseRecord record, Function<CaseRecord, CaseResult> judge) {
    records.accept(record);
    listener.caseRecorded(record);
    CaseResult result = judge.apply(record);
    finished.add(result);
    listener.caseFinished(result);
    return result;
  }

  /** What a build used in addition to the files of the application. */
  private record UsedTools(String compiler, List<ResolvedPackage> packages) {}

  private TestResult report(
      Execution execution,
      List<String> furtherSuspicions,
      ResultAssembler assembler,
      String bridge,
      UsedTools used,
      Instant started) {
    List<String> suspicions = new ArrayList<>(furtherSuspicions);
    suspicions.addAll(execution.suspicions());
    byte[] suite = application.files().content("suite.xml").orElseThrow();
    Provenance provenance =
        new Provenance(
            Digests.of(suite),
            application.suite().generation().seed(),
            Digests.of(application.harness()),
            Digests.of(componentFiles()),
            settings.agent(),
            bridge,
            used.compiler(),
            used.packages(),
            started.truncatedTo(ChronoUnit.MILLIS).toString(),
            Instant.now().truncatedTo(ChronoUnit.MILLIS).toString());
    return assembler
        .assemble(execution.results(), execution.reasonOfRest(), provenance)
        .withSuspicions(suspicions);
  }

  /** The files of the component: sources or library, adapter and external libraries. */
  private FileTree componentFiles() {
    ActivityProfile profile = application.activity().profile();
    Component component = profile.component();
    FileTree files = application.activity().files();
    FileTree found = FileTree.of(Map.of());
    for (String folder : new String[] {component.sources(), component.adapter()}) {
      if (folder != null) {
        found = found.with(folder, files.below(folder));
      }
    }
    for (String path : files.paths()) {
      if (path.equals(component.library()) || profile.libraries().contains(path)) {
        found = found.with(path, files.content(path).orElseThrow());
      }
    }
    return found;
  }

  private Path applicationDirectory() {
    return directory.resolve("application");
  }

  private static void remarkOn(BuildOutcome outcome, BuildLog log) {
    if (outcome instanceof BuildOutcome.CompilationFailed failed) {
      failed.diagnostics().forEach(diagnostic -> log.conclude(diagnostic.toString()));
      log.conclude(failed.message());
    } else if (outcome instanceof BuildOutcome.InfrastructureFailed failed) {
      log.conclude(failed.message());
    } else if (outcome instanceof BuildOutcome.Cancelled cancelled) {
      log.conclude("cancelled: " + cancelled.reason());
    }
  }
}
