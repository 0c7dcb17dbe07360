package org.sitaf.runtime;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.component.WatchedPorts;
import org.sitaf.runtime.output.CaseStreams;
import org.sitaf.runtime.simulation.CaseTooLongException;
import org.sitaf.runtime.simulation.Simulation;
import org.sitaf.runtime.simulation.SimulationException;
import org.sitaf.runtime.stub.Stubbing;
import org.sitaf.runtime.suite.CaseDataException;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.Outcome;
import org.sitaf.runtime.suite.ResultsFile;
import org.sitaf.runtime.suite.SuiteReader;
import org.sitaf.runtime.suite.TestCase;
import org.sitaf.runtime.suite.TestStep;

/**
 * Runs a suite in this process: reads the cases, passes each to the test driver, and writes a
 * record of every case, even when the component fails.
 */
public final class TestRun {
  /** Every case has a result. */
  static final int EXIT_DONE = 0;

  /** The suite could not be run or could not continue. */
  static final int EXIT_CANNOT_RUN = 3;

  private int currentNo;

  /** Whether the current call is repeated, so that only its time and its outputs count. */
  private boolean repeating;

  /** Whether a step of the current case has begun. */
  private boolean inSequence;

  private final Stopwatch stopwatch = new Stopwatch();
  private final WatchedPorts ports = new WatchedPorts();
  private final CommandLine command;
  private final SuiteReader suite;
  private final ResultsFile results;
  private final @Nullable Simulation simulation;
  private final Stubbing stubbing;

  private TestRun(CommandLine command, SuiteReader suite, ResultsFile results) throws IOException {
    this.command = command;
    this.suite = suite;
    this.results = results;
    String bridge = command.bridge();
    Path world = command.world();
    this.simulation =
        bridge == null || world == null
            ? null
            : Simulation.open(bridge, world, command.seed(), stopwatch, suite::upcoming);
    Duration atMost = command.caseSimulation();
    if (atMost != null && simulation != null) {
      simulation.limit(atMost);
    }
    this.stubbing = new Stubbing(stopwatch, simulation);
    if (simulation != null) {
      stopwatch.beforeCall(simulation::callBegins);
      simulation.beforeTimePasses(ports::take);
    }
    Path recording = command.recording();
    if (recording != null && simulation != null) {
      simulation.record(recording);
    }
  }

  /**
   * The {@code main} of a test application: runs the suite that the arguments name, then ends the
   * process with exit code 0 when every case has a result, or with 3 and one line on the error
   * stream when the suite could not be run.
   */
  public static void start(String[] arguments, Function<TestRun, ? extends SuiteDriver<?>> driver) {
    CaseStreams.install();
    System.exit(execute(arguments, driver));
  }

  /** Runs a suite and returns the exit code. */
  static int execute(String[] arguments, Function<TestRun, ? extends SuiteDriver<?>> driver) {
    try {
      TestRun early = EarlyStart.take(arguments);
      TestRun run = early == null ? open(arguments) : early;
      try (Closeable opened = run::close) {
        // Before any code of the component is loaded.
        run.results.authorise(EarlyStart::takeLine);
        run.runAll(driver);
      }
      return EXIT_DONE;
    } catch (CannotRunException | SimulationException | CaseDataException e) {
      return cannotRun(String.valueOf(e.getMessage()));
    } catch (IOException e) {
      return cannotRun(e.getClass().getSimpleName() + ": " + e.getMessage());
    } catch (LinkageError e) {
      return cannotRun("the test application does not fit together: " + e);
    }
  }

  /**
   * Opens everything that a run needs except the test application itself.
   *
   * @throws CannotRunException when the arguments are wrong
   * @throws CaseDataException when the file is not a suite
   * @throws SimulationException when the simulator refuses the world
   */
  static TestRun open(String[] arguments) throws IOException {
    CommandLine command = CommandLine.parse(arguments);
    SuiteReader suite = SuiteReader.open(command.suite());
    try {
      ResultsFile results = openResults(command);
      try {
        return new TestRun(command, suite, results);
      } catch (IOException | RuntimeException e) {
        results.close();
        throw e;
      }
    } catch (IOException | RuntimeException e) {
      suite.close();
      throw e;
    }
  }

  /** The simulator's session. */
  public Simulation simulation() {
    if (simulation == null) {
      throw new CannotRunException(
          "this test needs a simulation: start it with --bridge TARGET --world FILE.world.yaml");
    }
    return simulation;
  }

  /** The hardware for the component; empty when there is no simulation. */
  public Optional<Hardware> hardware() {
    return Optional.ofNullable(simulation).map(Simulation::hardware);
  }

  /** Measures the calls of this run. */
  public Stopwatch stopwatch() {
    return stopwatch;
  }

  /** The state that the stubbed methods of this run share. */
  public Stubbing stubbing() {
    return stubbing;
  }

  @Nullable Simulation simulationIfAny() {
    return simulation;
  }

  /** Records the value of an output data port until the end of the case. */
  void watch(String signal, Callable<String> read) throws Exception {
    if (simulation != null) {
      ports.watch(signal, read, simulation.nowNanos());
    }
  }

  /** Records the values of the output data ports now; throws what a port threw in this case. */
  void readPorts() throws Exception {
    if (simulation != null) {
      ports.take(simulation.nowNanos());
      ports.requireRead();
    }
  }

  /** Writes the record of a case with the calls of its stubs. */
  void save(CaseResult result) throws IOException {
    if (repeating) {
      ports.clear();
      if (simulation != null) {
        simulation.requireNotLost();
      }
      return;
    }
    if (simulation != null) {
      if (stopwatch.wasStarted() || inSequence) {
        simulation.keepSignals(currentNo);
      }
      ports.writeTo(result, simulation.nowNanos() - simulation.sinceCall());
      ports.clear();
      simulation.requireNotLost();
    }
    stubbing.writeTo(result);
    if (command.repetition() == null) {
      results.save(result);
    }
  }

  private static ResultsFile openResults(CommandLine command) throws IOException {
    return ResultsFile.open(command.results(), command.from() > 0);
  }

  private void close() throws IOException {
    try (suite;
        results) {
      if (simulation != null) {
        simulation.close();
      }
    }
  }

  private void runAll(Function<TestRun, ? extends SuiteDriver<?>> factory) throws IOException {
    int from = command.from();
    CurrentHardware.set(hardware().orElse(null));
    CoverageRecord.begin();
    try {
      SuiteDriver<?> driver = factory.apply(this);
      Optional<TestCase> next = suite.next();
      while (from > 0 && next.isPresent() && next.get().no() != from) {
        next = suite.next();
      }
      if (from > 0 && next.isEmpty()) {
        throw new CannotRunException("--from " + from + ": the suite has no case of that number");
      }
      results.ready();
      for (; next.isPresent(); next = suite.next()) {
        runOne(driver, next.get());
      }
      CaseStreams.begin(0);
      closing("closing the component", 0, driver::close);
    } finally {
      CurrentHardware.set(null);
    }
  }

  private void runOne(SuiteDriver<?> driver, TestCase testCase) throws IOException {
    CaseResult result = new CaseResult(testCase);
    CaseStreams.begin(testCase.no());
    currentNo = testCase.no();
    if (simulation != null) {
      simulation.caseBegins(currentNo);
    }
    Repetition repetition = command.repetition();
    if (repetition == null) {
      call(driver, testCase, result);
      return;
    }
    long begin = System.nanoTime();
    call(driver, testCase, result);
    if (result.isRepeatable()) {
      repeating = true;
      try {
        repeat(driver, testCase, result, repetition, begin);
      } finally {
        repeating = false;
      }
    }
    results.save(result);
  }

  /** Repeats the call of a case, each time in the same world and with a new component. */
  private void repeat(
      SuiteDriver<?> driver, TestCase testCase, CaseResult first, Repetition repetition, long begin)
      throws IOException {
    int calls = repetition.warmUp() + repetition.repeat();
    long within = repetition.within().toNanos();
    first.beginRepeated();
    for (int i = 0; i < calls && System.nanoTime() - begin <= within; i++) {
      CaseResult again = new CaseResult(testCase);
      call(driver, testCase, again);
      first.addRepeated(again, i + 2, i >= repetition.warmUp());
    }
  }

  private void call(SuiteDriver<?> driver, TestCase testCase, CaseResult result)
      throws IOException {
    stopwatch.reset();
    stubbing.begin();
    inSequence = false;
    try {
      if (!driver.runAndSave(testCase, result)) {
        throw new CannotRunException(
            "the test driver ended case " + testCase.no() + " without save(result)");
      }
    } catch (Throwable thrown) {
      if (driver.isSaved()) {
        System.err.println(
            "sitaf: after case " + testCase.no() + ": " + ThrownByComponent.describe(thrown));
      } else {
        end(result, thrown, stopwatch);
        save(result);
      }
    } finally {
      if (simulation != null && !repeating) {
        closing("recording case", testCase.no(), () -> simulation.saveMotion(testCase.no()));
      }
      closing("closing the component after case", testCase.no(), driver::endCase);
    }
  }

  /**
   * Executes a step of a sequence and writes its record. An exception ends the step, not the
   * sequence.
   *
   * @return whether the next step can be executed: not when the case took too much simulation time
   * @throws RuntimeException when no further case can run
   */
  <C> boolean runStep(SequenceDriver<C> driver, TestStep step, CaseResult result)
      throws IOException, InterruptedException {
    stepBegins(result);
    boolean goesOn = executeStep(driver, step, result) == null;
    stubbing.moveTo(result);
    results.save(result);
    return goesOn;
  }

  /** Notes in the record of a step when it begins. */
  void stepBegins(CaseResult result) {
    if (simulation != null) {
      if (!inSequence) {
        simulation.callBegins();
      }
      result.beganAt(simulation.sinceCall());
    }
    inSequence = true;
  }

  /**
   * Executes a step in the calling thread, with the stopwatch of this thread.
   *
   * @return the exception when the case took too much simulation time
   * @throws RuntimeException when no further case can run
   */
  <C> @Nullable CaseTooLongException executeStep(
      SequenceDriver<C> driver, TestStep step, CaseResult result) throws InterruptedException {
    Stopwatch watch = stopwatch.ofThisThread();
    watch.reset();
    CaseTooLongException tooLong = null;
    try {
      driver.runStep(step, result);
      if (watch.wasStarted()) {
        setTime(result, watch);
      }
    } catch (Throwable thrown) {
      tooLong = thrown instanceof CaseTooLongException found ? found : null;
      end(result, thrown, watch);
    } finally {
      driver.giveUpCall();
    }
    if (simulation != null) {
      simulation.requireNotLost();
    }
    return tooLong;
  }

  /** Moves the calls of stubs so far to the record of the step that began last. */
  void moveCallsTo(CaseResult result) {
    stubbing.moveTo(result);
  }

  /** Writes the record of a step that is complete. */
  void saveStep(CaseResult result) throws IOException {
    results.save(result);
  }

  /** The steps of a sequence have ended; what fails from now on is not a call. */
  void endSteps() {
    stopwatch.reset();
  }

  private static void setTime(CaseResult result, Stopwatch watch) {
    result.setTime(watch.componentMicros(), watch.hardwareMicros(), watch.stubMicros());
  }

  /**
   * Completes the record of a case that did not save its result.
   *
   * @throws RuntimeException the given exception, when no further case can run
   */
  private void end(CaseResult result, Throwable thrown, Stopwatch watch) {
    // An interrupt that the component leaves behind must not affect the next case.
    Thread.interrupted();
    if (simulation != null) {
      simulation.requireNotLost();
    }
    if (thrown instanceof CaseTooLongException tooLong) {
      result.endWith(Outcome.ERROR, String.valueOf(tooLong.getMessage()));
    } else if (watch.isRunning()) {
      watch.stop();
      setTime(result, watch);
      result.threw(thrown, ThrownByComponent.describe(thrown));
    } else if (thrown instanceof CannotRunException cannotRun) {
      throw cannotRun;
    } else if (thrown instanceof SimulationException refused) {
      if (refused.isLost()) {
        throw refused;
      }
      result.endWith(
          watch.wasStarted() ? Outcome.ERROR : Outcome.NOT_CALLED,
          String.valueOf(refused.getMessage()));
    } else if (thrown instanceof CaseDataException unreadable) {
      result.endWith(Outcome.NOT_CALLED, String.valueOf(unreadable.getMessage()));
    } else if (thrown instanceof NoClassDefFoundError missing
        && missing.getCause() instanceof ClassNotFoundException) {
      throw new CannotRunException(
          "class "
              + missing.getMessage()
              + " is missing: is it among the component's files and libraries?",
          missing);
    } else {
      result.endWith(Outcome.ERROR, ThrownByComponent.describe(thrown));
    }
  }

  /**
   * Runs a clean-up step after a case. A failure is printed and does not change the result.
   *
   * @param no of the case; 0 after the last
   */
  private static void closing(String what, int no, Closing closing) {
    try {
      closing.run();
    } catch (Exception | Error e) {
      String which = no == 0 ? "" : " " + no;
      System.err.println("sitaf: " + what + which + ": " + ThrownByComponent.describe(e));
    }
  }

  private static int cannotRun(String reason) {
    System.err.println("sitaf: " + reason.strip().replaceAll("\\s*\\R\\s*", "; "));
    return EXIT_CANNOT_RUN;
  }

  private interface Closing {
    void run() throws Exception;
  }
}
