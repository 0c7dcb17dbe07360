package org.sitaf.agent.executor;

import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.simulation.SimulatorEnd;
import org.sitaf.agent.simulation.SimulatorEndpoint;
import org.sitaf.agent.spool.FreeSpace;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;

/**
 * Executes a suite. If a case crashes or hangs, its process is killed and a new process continues
 * with the next case. All results that a process wrote are kept, however it ends.
 *
 * @param startUp time until a process must be ready for its first case
 * @param crashesInARow after this many processes that ended in their first case, the remaining
 *     cases are not executed
 * @param atMost time limit for all cases; the remaining cases are not executed
 */
public record TestApplicationExecutor(Duration startUp, int crashesInARow, Duration atMost) {
  /** The defaults of agents, without a time limit for all cases. */
  public static final TestApplicationExecutor DEFAULT =
      new TestApplicationExecutor(Duration.ofSeconds(30), 20, Duration.ofDays(1000));

  private static final Duration POLL = Duration.ofMillis(10);

  /** While results arrive: the pipe of a fast test application fills up quickly. */
  private static final Duration BUSY_POLL = Duration.ofMillis(1);

  private static final Duration EXIT_GRACE = Duration.ofSeconds(2);

  /** Number of times that a simulator is replaced before the build fails. */
  private static final int MAX_SIMULATOR_RESTARTS = 3;

  /** Ends of the simulator in one case after which the case is at fault. */
  private static final int MAX_ENDS_PER_CASE = 2;

  private static final int MAX_STARTS = 2;

  public TestApplicationExecutor {
    Objects.requireNonNull(startUp);
    Objects.requireNonNull(atMost);
    if (crashesInARow < 1) {
      throw new IllegalArgumentException("crashesInARow must be at least 1");
    }
  }

  /** With the given time for a process to become ready. */
  public TestApplicationExecutor startingWithin(Duration limit) {
    return new TestApplicationExecutor(limit, crashesInARow, atMost);
  }

  /** With a time limit for all cases. */
  public TestApplicationExecutor within(Duration limit) {
    return new TestApplicationExecutor(startUp, crashesInARow, limit);
  }

  /**
   * Runs the cases.
   *
   * @param early the first process, started during the compilation; null if there is none
   * @param judge gives the result of each recorded case as soon as it is read
   * @throws IOException if no process can be started
   * @throws InterruptedException if the build was cancelled; its processes are killed
   */
  public Execution execute(
      ExecutionRequest request,
      @Nullable EarlyProcess early,
      OutputSink sink,
      Function<CaseRecord, CaseResult> judge)
      throws IOException, InterruptedException {
    CaseProgress progress = new CaseProgress(request.suite(), request.timing(), judge, sink);
    Run run = new Run(request, early, progress, sink);
    String reason = "";
    while (!progress.isComplete() && reason.isEmpty()) {
      reason = run.oneProcess();
    }
    return new Execution(
        progress.results(), progress.isComplete() ? "" : reason, progress.suspicions());
  }

  /** How a process ended. */
  private enum Follow {
    ENDED,
    NO_ANSWER,
    NOT_READY,
    OUT_OF_TIME,
    SIMULATOR_ENDED,
    TOO_MUCH
  }

  /** State that is kept between processes. */
  private final class Run {
    private ExecutionRequest request;
    private final CaseProgress progress;
    private final OutputSink sink;
    private final long end = System.nanoTime() + atMost.toNanos();
    private int crashesInFirstCase;
    private final SimulatorEnds simulatorEnds =
        new SimulatorEnds(MAX_ENDS_PER_CASE, MAX_SIMULATOR_RESTARTS);
    private int failedStarts;
    private @Nullable EarlyProcess early;

    Run(
        ExecutionRequest request,
        @Nullable EarlyProcess early,
        CaseProgress progress,
        OutputSink sink) {
      this.request = request;
      this.early = early;
      this.progress = progress;
      this.sink = sink;
    }

    /** Runs one process; returns why no further one may start, or an empty text. */
    String oneProcess() throws IOException, InterruptedException {
      int before = progress.count();
      progress.beginProcess();
      EarlyProcess waiting = early;
      early = null;
      try (SimulatorEndpoint simulator =
              waiting == null ? request.newEndpoint() : waiting.simulator();
          HarnessProcess process =
              waiting == null
                  ? HarnessProcess.start(request, progress.current().no(), simulator, sink)
                  : waiting.release()) {
        request = request.withoutDebugging();
        Follow how = follow(process, simulator);
        String where = "";
        if (how == Follow.NO_ANSWER) {
          where = request.application().hangLocation(process.stacks()).orElse("");
        }
        if (simulator != null) {
          simulator.stopDevices();
        }
        if (how != Follow.ENDED) {
          process.kill();
        }
        ProcessEnd end = process.end();
        int current = progress.isComplete() ? 0 : progress.current().no();
        drain(process);
        if (end.code() == 0 && process.results().torn() > 0) {
          progress.suspect(
              "the last line is incomplete, although the process ended with exit code 0");
        }
        if (progress.isComplete()) {
          return "";
        }
        if (progress.isFull()) {
          sink.remark(progress.whyFull());
          return progress.whyFull();
        }
        if (how == Follow.OUT_OF_TIME) {
          return "the cases exceeded their total time of " + seconds(atMost);
        }
        // A full disk is not the fault of a case, because components have their own disk limit.
        FreeSpace.ofBuild(request.files()).require();
        crashesInFirstCase = progress.count() == before ? crashesInFirstCase + 1 : 0;
        Optional<SimulatorEnd> simulatorEnd =
            simulator == null || how == Follow.NO_ANSWER ? Optional.empty() : simulator.end();
        if (simulatorEnd.isPresent()) {
          return afterSimulator(simulatorEnd.get());
        }
        if (end.cannotGoOn() && !disconnectedByComponent(end, simulator)) {
          return end.reason().isEmpty() ? "the test application cannot continue" : end.reason();
        }
        if (!progress.isReady()) {
          return notReady(how, end);
        }
        if (how == Follow.ENDED || current == progress.current().no()) {
          String cause =
              how == Follow.NO_ANSWER || !end.exceededLimit().isEmpty()
                  ? ""
                  : request.application().crashCause(process.errors()).orElse("");
          failCurrentCase(how, where, end, cause);
        }
        return crashesInFirstCase < crashesInARow
            ? ""
            : crashesInFirstCase
                + " test applications in a row ended in their first case; the last with "
                + end.describe();
      }
    }

    /** No case had started, so none is at fault; the start is retried once. */
    private String notReady(Follow how, ProcessEnd end) {
      String message =
          how == Follow.NOT_READY
              ? "the test application was not ready within " + seconds(startUp)
              : "the test application ended before its first case with " + end.describe();
      sink.remark(message);
      return ++failedStarts < MAX_STARTS ? "" : message;
    }

    private void failCurrentCase(Follow how, String where, ProcessEnd end, String cause) {
      String message =
          how == Follow.NO_ANSWER
              ? "no answer within "
                  + seconds(request.limits().caseWall())
                  + (where.isEmpty() ? "" : ", at " + where)
              : cause.isEmpty() ? "the test application ended with " + end.describe() : cause;
      sink.remark("case " + progress.current().no() + ": " + message);
      progress.currentFailed(message);
    }

    /** Whether the component disconnected from a simulator that still answers. */
    private boolean disconnectedByComponent(ProcessEnd end, @Nullable SimulatorEndpoint simulator) {
      return progress.isReady()
          && end.lostSimulator()
          && simulator != null
          && !simulator.isShared();
    }

    /**
     * A simulator that crashed is replaced and the case is repeated. A case that crashes simulators
     * repeatedly is at fault.
     */
    private String afterSimulator(SimulatorEnd end) {
      SimulatorEnds.Consequence consequence =
          simulatorEnds.after(progress.current().no(), progress.isReady(), end);
      sink.remark(consequence.message());
      switch (consequence.next()) {
        case BLAME_CASE -> progress.currentFailed(consequence.message());
        case GIVE_UP -> {
          return consequence.message();
        }
        case TRY_AGAIN -> {
          // The case is repeated with a new simulator.
        }
      }
      return "";
    }

    private Follow follow(HarnessProcess process, @Nullable SimulatorEndpoint simulator)
        throws IOException, InterruptedException {
      Duration limit = request.limits().caseWall();
      long deadline = System.nanoTime() + startUp.toNanos();
      Duration pause = POLL;
      while (true) {
        boolean ended = process.awaitEnd(pause);
        int cases = progress.count();
        boolean wasReady = progress.isReady();
        boolean more = drain(process);
        pause = more ? BUSY_POLL : POLL;
        if (progress.isFull()) {
          return Follow.TOO_MUCH;
        }
        // The steps of a sequence share the time of their case.
        if (progress.count() > cases || progress.isReady() != wasReady) {
          deadline = System.nanoTime() + limit.toNanos();
        }
        if (ended) {
          return Follow.ENDED;
        }
        if (progress.isComplete()) {
          if (!process.awaitEnd(EXIT_GRACE)) {
            sink.remark("the test application did not end after its last case and was killed");
            process.kill();
          }
          return Follow.ENDED;
        }
        if (simulator != null && simulator.hasEnded()) {
          // A test application notices the end itself, unless it no longer needs the simulator.
          return process.awaitEnd(EXIT_GRACE) ? Follow.ENDED : Follow.SIMULATOR_ENDED;
        }
        if (System.nanoTime() - deadline > 0) {
          return progress.isReady() ? Follow.NO_ANSWER : Follow.NOT_READY;
        }
        if (System.nanoTime() - end > 0) {
          return Follow.OUT_OF_TIME;
        }
      }
    }

    /** Reads new results; returns whether the test application made progress. */
    private boolean drain(HarnessProcess process) throws IOException {
      progress.processHasRun(process.ranMicros());
      return process.results().read(progress);
    }
  }

  private static String seconds(Duration duration) {
    double seconds = duration.toMillis() / 1000.0;
    return seconds == Math.rint(seconds) ? (long) seconds + " s" : seconds + " s";
  }
}
