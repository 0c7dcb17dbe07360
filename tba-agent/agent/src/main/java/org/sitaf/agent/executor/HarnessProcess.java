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
import org.sitaf.agent.toolchain.debug.DebugOrder;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.core.timing.Timing;

/** A process of a test application. */
final class HarnessProcess implements AutoCloseable {
  private static final Duration OUTPUT_TIMEOUT = Duration.ofSeconds(2);

  /** Limit for processes and threads, including those of the runtime. */
  private static final int PROCESSES = 512;

  private static final int FILE_MIB = 256;

  /** Processor time per wall-clock time of a case, because threads may run in parallel. */
  private static final int CPU_FACTOR = 4;

  private final long started = System.nanoTime();
  private final ConfinedProcess process;
  private final ResultsChannel results;
  private final OutputFolders outputFolders;
  private final LastLine lastLine = new LastLine();
  private final Answer answer = new Answer();
  private final ErrorTail errorTail = new ErrorTail();
  private final List<Thread> pumps;

  private HarnessProcess(
      ConfinedProcess process,
      ResultsChannel results,
      OutputFolders outputFolders,
      OutputSink sink) {
    this.process = process;
    this.results = results;
    this.outputFolders = outputFolders;
    this.pumps =
        List.of(
            pump(
                process.output(),
                new CaseMarks(
                    (text, caseNo) -> {
                      answer.add(text);
                      sink.output(text, caseNo);
                    })),
            pump(
                process.errors(),
                new CaseMarks(
                    (text, caseNo) -> {
                      lastLine.add(text);
                      errorTail.add(text);
                      answer.add(text);
                      sink.output(text, caseNo);
                    })));
  }

  /**
   * Starts a process that begins with the given case.
   *
   * @throws IOException if the process or its simulator cannot be started
   */
  static HarnessProcess start(
      ExecutionRequest request,
      int fromCase,
      @Nullable SimulatorEndpoint simulator,
      OutputSink sink)
      throws IOException, InterruptedException {
    HarnessProcess started = startWaiting(request, fromCase, simulator, sink);
    started.release();
    return started;
  }

  /** Like {@link #start}; the process waits for {@link #release}. */
  static HarnessProcess startWaiting(
      ExecutionRequest request, int fromCase, @Nullable SimulatorEndpoint endpoint, OutputSink sink)
      throws IOException, InterruptedException {
    CompiledApplication application = request.application();
    Path working = Files.createDirectories(request.directory().resolve("run"));
    Path temporary = Files.createDirectories(request.directory().resolve("tmp"));
    Path coverage = application.recordsCoverage() ? request.newCoverageFolder() : null;
    int memoryMiB = request.limits().memoryMiB();
    DebugOrder order = request.debugging();
    DebugPlace debugging = order == null ? null : DebugPlace.in(request.directory(), order);
    ProcessPlace place =
        new ProcessPlace(temporary, coverage, memoryMiB, request.variation(), debugging);
    List<String> command = new ArrayList<>();
    if (debugging != null) {
      // Ctrl-C in the terminal is for the debugger.
      command.add("setsid");
    }
    command.addAll(application.command(place));
    SimulatorAddress simulator = endpoint == null ? null : new SimulatorAddress(endpoint.target());
    command.addAll(arguments(request, fromCase, simulator));
    Path recording = simulator == null ? null : request.recording();
    if (recording != null) {
      command.addAll(List.of("--recording", Files.createDirectories(recording).toString()));
    }
    ProcessLimits limits =
        new ProcessLimits(
            memoryMiB + application.overheadMiB(),
            PROCESSES,
            FILE_MIB,
            processorTime(request),
            application.reservesMemory());
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
      ConfinedProcess process = request.sandbox().start(confinement.withChannel(results.pipe()));
      if (order != null && debugging != null) {
        order.waiting().accept(application.debuggee(debugging, process.pid()));
      }
      return new HarnessProcess(
          process, results, new OutputFolders(working, temporary, coverage, recording), sink);
    } catch (IOException | RuntimeException e) {
      results.close();
      throw e;
    }
  }

  /** Processor time for all cases, each of which may use its full time. */
  private static Duration processorTime(ExecutionRequest request) {
    return request
        .limits()
        .caseWall()
        .multipliedBy((long) CPU_FACTOR * request.suite().cases().size())
        .plusMinutes(1);
  }

  /** The arguments of a test application in any language. */
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
    Timing timing = request.timing();
    if (timing != null) {
      arguments.add("--warm-up");
      arguments.add(Integer.toString(timing.warmUp()));
      arguments.add("--repeat");
      arguments.add(Integer.toString(timing.repeat()));
      // A call that begins later could end after the time limit of the case.
      arguments.add("--repeat-within");
      arguments.add(seconds(request.limits().caseWall().dividedBy(2)));
    }
    return arguments;
  }

  private static String seconds(Duration duration) {
    return BigDecimal.valueOf(duration.toNanos(), 9).stripTrailingZeros().toPlainString();
  }

  /** Lets a waiting process continue, with the token of its results. */
  void release() {
    process.release(results.token());
  }

  /** Time since the start. */
  double ranMicros() {
    return (System.nanoTime() - started) / 1000.0;
  }

  /** The lines that it writes about its cases. */
  ResultsChannel results() {
    return results;
  }

  /** Waits for the end; returns whether the process ended within that time. */
  boolean awaitEnd(Duration atMost) throws InterruptedException {
    return process.awaitEnd(atMost);
  }

  /** Requests the stack traces of the process, which may end it; kill the process afterwards. */
  String stacks() throws InterruptedException {
    answer.begin();
    process.requestStackTraces();
    return answer.untilQuiet();
  }

  /** The end of its error stream; complete after {@link #end()}. */
  String errors() {
    return errorTail.get();
  }

  /** Kills it and all processes that it started. */
  void kill() throws InterruptedException {
    process.kill();
  }

  /** How it ended; valid after the end only. */
  ProcessEnd end() throws InterruptedException {
    process.killLeftovers();
    for (Thread pump : pumps) {
      pump.join(OUTPUT_TIMEOUT.toMillis());
    }
    outputFolders.makeRoom(process.exceededLimit().isPresent());
    return new ProcessEnd(process.exitCode(), process.exceededLimit().orElse(""), lastLine.get());
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
              // Invalid UTF-8 becomes replacement characters, so the log is always text.
              try (Reader reader = new InputStreamReader(stream, StandardCharsets.UTF_8)) {
                char[] buffer = new char[8192];
                for (int n = reader.read(buffer); n >= 0; n = reader.read(buffer)) {
                  sink.read(new String(buffer, 0, n));
                }
              } catch (IOException e) {
                // The process has ended.
              }
            },
            "sitaf-output");
    thread.setDaemon(true);
    thread.start();
    return thread;
  }
}
