package org.sitaf.agent.executor;

import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.simulation.SimulatorEnd;
import org.sitaf.agent.simulation.SimulatorEndpoint;
import org.sitaf.agent.spool.FreeSpace;
import org.sitaf.core.verdict.CaseResult;

/**
 * Executes a suite. A case that crashes or hangs costs its process; the cases after it go on in a
 * fresh one. What a process has written is kept, however it ends.
 *
 * @param startUp what a process may take until it is ready for its first case
 * @param crashesInARow after so many processes that ended in their first case the rest is not
 *     executed
 * @param atMost what all cases together may take; the rest is not executed then
 */
public record TestApplicationExecutor(Duration startUp, int crashesInARow, Duration atMost) {
  /** What agents use, without a limit for all cases together. */
  public static final TestApplicationExecutor DEFAULT =
      new TestApplicationExecutor(Duration.ofSeconds(30), 20, Duration.ofDays(1000));

  private static final Duration POLL = Duration.ofMillis(10);

  /** While results come: the pipe of a fast test application is full soon. */
  private static final Duration BUSY_POLL = Duration.ofMillis(1);

  private static final Duration EXIT_GRACE = Duration.ofSeconds(2);

  /** A simulator that ended may be replaced so often; then it is not the machine's bad luck. */
  private static final int SIMULATOR_RESTARTS = 3;

  /** In a case that ends the simulator so often the component or the world does it. */
  private static final int ENDS_IN_A_CASE = 2;

  private static final int STARTS = 2;

  public TestApplicationExecutor {
    Objects.requireNonNull(startUp);
    Objects.requireNonNull(atMost);
    if (crashesInARow < 1) {
      throw new IllegalArgumentException("crashesInARow must be at least 1");
    }
  }

  /** With a limit for all cases together. */
  public TestApplicationExecutor within(Duration limit) {
    return new TestApplicationExecutor(startUp, crashesInARow, limit);
  }

  /**
   * Runs the cases.
   *
   * @param early the first process, started before the application was compiled; null where there
   *     is none
   * @param onResult is told each result the moment it is known, and may judge it differently
   * @throws IOException if no process can be started at all
   * @throws InterruptedException if the build was cancelled; its processes are gone then
   */
  public Execution execute(
      ExecutionRequest request,
      @Nullable EarlyProcess early,
      OutputSink sink,
      UnaryOperator<CaseResult> onResult)
      throws IOException, InterruptedException {
    CaseProgress progress = new CaseProgress(request.suite(), onResult, sink);
    Run run = new Run(request, early, progress, sink);
    String reason = "";
    while (!progress.isComplete() && reason.isEmpty()) {
      reason = run.oneProcess();
    }
    return new Execution(
        progress.results(), progress.isComplete() ? "" : reason, progress.suspicions());
  }

  /** How following a process came to its end. */
  private enum Follow {
    ENDED,
    NO_ANSWER,
    NOT_READY,
    OUT_OF_TIME,
    SIMULATOR_ENDED,
    TOO_MUCH
  }

  /** What is known from one process to the next. */
  private final class Run {
    private final ExecutionRequest request;
    private final CaseProgress progress;
    private final OutputSink sink;
    private final long end = System.nanoTime() + atMost.toNanos();
    private int barrenProcesses;
    private final SimulatorEnds simulatorEnds =
        new SimulatorEnds(ENDS_IN_A_CASE, SIMULATOR_RESTARTS);
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

    /** Runs one process to its end; returns why no further one may be started, or nothing. */
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
        Follow how = follow(process, simulator);
        String where = "";
        if (how == Follow.NO_ANSWER) {
          where = request.application().hangLocation(process.stacks()).orElse("");
        }
        if (how != Follow.ENDED) {
          process.kill();
        }
        ProcessEnd end = process.end();
        int current = progress.isComplete() ? 0 : progress.current().no();
        drain(process);
        if (end.code() == 0 && process.results().torn() > 0) {
          progress.suspect("the last line is torn, though its process ended with exit code 0");
        }
        if (progress.isComplete()) {
          return "";
        }
        if (progress.isFull()) {
          sink.remark(progress.whyFull());
          return progress.whyFull();
        }
        if (how == Follow.OUT_OF_TIME) {
          return "all cases together took longer than " + seconds(atMost);
        }
        // No case is at fault for what could not be written; what a component may write has a
        // limit of its own.
        FreeSpace.ofBuild(request.files()).require();
        barrenProcesses = progress.count() == before ? barrenProcesses + 1 : 0;
        Optional<SimulatorEnd> simulatorEnd =
            simulator == null || how == Follow.NO_ANSWER ? Optional.empty() : simulator.end();
        if (simulatorEnd.isPresent()) {
          return afterSimulator(simulatorEnd.get());
        }
        if (end.cannotGoOn() && !lostByItself(end, simulator)) {
          return end.reason().isEmpty() ? "the test application cannot go on" : end.reason();
        }
        if (!progress.isReady()) {
          return notReady(how, end);
        }
        if (how == Follow.ENDED || current == progress.current().no()) {
          blameCurrentCase(how, where, end);
        }
        return barrenProcesses < crashesInARow
            ? ""
            : barrenProcesses
                + " test applications in a row ended in their first case; the last with "
                + end.describe();
      }
    }

    /** No case had begun, so none is at fault; once may be bad luck of the machine. */
    private String notReady(Follow how, ProcessEnd end) {
      String message =
          how == Follow.NOT_READY
              ? "the test application was not ready within " + seconds(startUp)
              : "the test application ended before its first case with " + end.describe();
      sink.remark(message);
      return ++failedStarts < STARTS ? "" : message;
    }

    private void blameCurrentCase(Follow how, String where, ProcessEnd end) {
      String message =
          how == Follow.NO_ANSWER
              ? "no answer within "
                  + seconds(request.limits().caseWall())
                  + (where.isEmpty() ? "" : ", at " + where)
              : "the test application ended with " + end.describe();
      sink.remark("case " + progress.current().no() + ": " + message);
      progress.currentFailed(message);
    }

    /** A simulator that answers was not lost, but left: by the component, in the current case. */
    private boolean lostByItself(ProcessEnd end, @Nullable SimulatorEndpoint simulator) {
      return progress.isReady()
          && end.lostSimulator()
          && simulator != null
          && !simulator.isShared();
    }

    /**
     * A simulator that died is the agent's matter: the case was not at fault and is tried again
     * with a fresh one. A case that ends simulators is at fault.
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
          // The case goes on where it began, with a fresh simulator.
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
        boolean more = drain(process);
        pause = more ? BUSY_POLL : POLL;
        if (progress.isFull()) {
          return Follow.TOO_MUCH;
        }
        if (more) {
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
          // A test application that notices ends by itself, and one that needs no more of it ends
          // well.
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

    /** Takes what is new of the results; true when the test application showed that it works on. */
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
