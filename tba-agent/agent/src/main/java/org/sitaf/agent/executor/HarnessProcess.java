package org.sitaf.agent.executor;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.ExecutionRequest.World;
import org.sitaf.agent.sandbox.ConfinedProcess;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.simulation.SimulatorEndpoint;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.ProcessPlace;

/** A test application at work, in a process of its own. */
final class HarnessProcess implements AutoCloseable {
  private static final Duration OUTPUT_GRACE = Duration.ofSeconds(2);

  /** Threads of the runtime among them. */
  private static final int PROCESSES = 512;

  private static final int FILE_MIB = 256;

  /** Processor time for a case beyond its wall-clock time, as threads may share the work. */
  private static final int CPU_FACTOR = 4;

  private final long started = System.nanoTime();
  private final ConfinedProcess process;
  private final ResultsChannel results;
  private final Written written;
  private final LastWords lastWords = new LastWords();
  private final Answer heard = new Answer();
  private final List<Thread> pumps;

  private HarnessProcess(
      ConfinedProcess process, ResultsChannel results, Written written, OutputSink sink) {
    this.process = process;
    this.results = results;
    this.written = written;
    this.pumps =
        List.of(
            pump(
                process.output(),
                new CaseMarks(
                    (text, caseNo) -> {
                      heard.add(text);
                      sink.output(text, caseNo);
                    })),
            pump(
                process.errors(),
                new CaseMarks(
                    (text, caseNo) -> {
                      lastWords.add(text);
                      heard.add(text);
                      sink.output(text, caseNo);
                    })));
  }

  /**
   * Starts a process that begins at a case.
   *
   * @throws IOException if the process cannot be started, or its simulator is not there
   */
  static HarnessProcess start(
      ExecutionRequest request,
      int fromCase,
      @Nullable SimulatorEndpoint simulator,
      OutputSink sink)
      throws IOException, InterruptedException {
    HarnessProcess started = startHeldBack(request, fromCase, simulator, sink);
    started.release();
    return started;
  }

  /** As {@link #start}, and it waits for {@link #release}. */
  static HarnessProcess startHeldBack(
      ExecutionRequest request, int fromCase, @Nullable SimulatorEndpoint endpoint, OutputSink sink)
      throws IOException, InterruptedException {
    CompiledApplication application = request.application();
    Path working = Files.createDirectories(request.directory().resolve("run"));
    Path temporary = Files.createDirectories(request.directory().resolve("tmp"));
    Path coverage = application.recordsCoverage() ? request.newCoverageFolder() : null;
    int memoryMiB = request.limits().memoryMiB();
    ProcessPlace place = new ProcessPlace(temporary, coverage, memoryMiB);
    List<String> command = new ArrayList<>(application.command(place));
    SimulatorAddress simulator = endpoint == null ? null : new SimulatorAddress(endpoint.target());
    command.addAll(arguments(request, fromCase, simulator));
    Path recording = simulator == null ? null : request.recording();
    if (recording != null) {
      command.addAll(List.of("--recording", Files.createDirectories(recording).toString()));
    }
    ProcessLimits limits =
        new ProcessLimits(
            memoryMiB + application.overheadMiB(), PROCESSES, FILE_MIB, processorTime(request));
    Confinement confinement =
        Confinement.of(command, working, temporary, limits)
            .withEnvironment(application.environment(place))
            .reading(application.readable())
            .reading(List.of(request.files(), request.suiteFile()))
            .withInputOpen();
    if (coverage != null) {
      confinement = confinement.writing(List.of(coverage));
    }
    if (recording != null) {
      confinement = confinement.writing(List.of(recording));
    }
    if (simulator != null) {
      confinement = simulator.grantedTo(confinement);
    }
    ResultsChannel results = ResultsChannel.open(request.directory());
    try {
      return new HarnessProcess(
          request.sandbox().start(confinement.withChannel(results.pipe())),
          results,
          new Written(working, temporary, coverage, recording),
          sink);
    } catch (IOException | RuntimeException e) {
      results.close();
      throw e;
    }
  }

  /** All cases may use their wall-clock time to the end. */
  private static Duration processorTime(ExecutionRequest request) {
    return request
        .limits()
        .caseWall()
        .multipliedBy((long) CPU_FACTOR * request.suite().cases().size())
        .plusMinutes(1);
  }

  /** What each test application is told, whatever its language. */
  private static List<String> arguments(
      ExecutionRequest request, int fromCase, @Nullable SimulatorAddress simulator) {
    List<String> arguments = new ArrayList<>();
    arguments.add("--suite");
    arguments.add(request.suiteFile().toString());
    arguments.add("--results");
    arguments.add("fd:" + Confinement.CHANNEL);
    World world = request.world();
    if (world != null && simulator != null) {
      arguments.add("--bridge");
      arguments.add(simulator.target());
      arguments.add("--world");
      arguments.add(world.description().toString());
    }
    arguments.add("--seed");
    arguments.add(Long.toString(request.suite().generation().seed()));
    arguments.add("--from");
    arguments.add(Integer.toString(fromCase));
    arguments.add("--case-sim");
    arguments.add(seconds(request.limits().caseSimulation()));
    return arguments;
  }

  private static String seconds(Duration duration) {
    return BigDecimal.valueOf(duration.toNanos(), 9).stripTrailingZeros().toPlainString();
  }

  /** Lets a process go on that was held back, with the token of its results. */
  void release() {
    process.release(results.token());
  }

  /** For how long it has run. */
  double ranMicros() {
    return (System.nanoTime() - started) / 1000.0;
  }

  /** What it writes about its cases. */
  ResultsChannel results() {
    return results;
  }

  /** Waits for the end; true when it came within that time. */
  boolean awaitEnd(Duration atMost) throws InterruptedException {
    return process.awaitEnd(atMost);
  }

  /**
   * What it prints when it is asked where it is; it may end of the question, and is to be killed
   * afterwards.
   */
  String stacks() throws InterruptedException {
    heard.begin();
    process.requestStackTraces();
    return heard.untilQuiet();
  }

  /** Ends it now, with all that it started. */
  void kill() throws InterruptedException {
    process.kill();
  }

  /** How it ended; only after its end. */
  ProcessEnd end() throws InterruptedException {
    process.killLeftovers();
    for (Thread pump : pumps) {
      pump.join(OUTPUT_GRACE.toMillis());
    }
    written.makeRoom(process.exceededLimit().isPresent());
    return new ProcessEnd(process.exitCode(), process.exceededLimit().orElse(""), lastWords.get());
  }

  @Override
  public void close() {
    process.close();
    results.close();
  }

  private static Thread pump(InputStream stream, CaseMarks sink) {
    Thread thread =
        new Thread(
            () -> {
              // Bytes that are no UTF-8 become replacement characters here; the log is always text.
              try (Reader reader = new InputStreamReader(stream, StandardCharsets.UTF_8)) {
                char[] buffer = new char[8192];
                for (int n = reader.read(buffer); n >= 0; n = reader.read(buffer)) {
                  sink.read(new String(buffer, 0, n));
                }
              } catch (IOException e) {
                // The process is gone, and its output with it.
              }
            },
            "sitaf-output");
    thread.setDaemon(true);
    thread.start();
    return thread;
  }
}
