package org.sitaf.agent.executor;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.simulation.SimulatorEndpoint;

/**
 * The first process of a test application, started while the application is still being compiled.
 * It is confined as any other and runs nothing of the user's until it is let go.
 */
public final class EarlyProcess implements AutoCloseable {
  private final HarnessProcess process;
  private final @Nullable SimulatorEndpoint simulator;
  private boolean gone;

  private EarlyProcess(HarnessProcess process, @Nullable SimulatorEndpoint simulator) {
    this.process = process;
    this.simulator = simulator;
  }

  /**
   * Starts it.
   *
   * @param request as it will be executed, with an application that was opened early
   * @throws IOException if it cannot be started, or its simulator is not there
   */
  public static EarlyProcess start(ExecutionRequest request, OutputSink sink)
      throws IOException, InterruptedException {
    int first = request.suite().cases().get(0).no();
    SimulatorEndpoint simulator = request.newEndpoint();
    try {
      return new EarlyProcess(
          HarnessProcess.startHeldBack(request, first, simulator, sink), simulator);
    } catch (IOException | InterruptedException | RuntimeException e) {
      if (simulator != null) {
        simulator.close();
      }
      throw e;
    }
  }

  /** What it reaches of the simulator; the caller of release closes it. */
  @Nullable SimulatorEndpoint simulator() {
    return simulator;
  }

  /** The process, which now goes on; whoever takes it closes it. */
  HarnessProcess release() {
    gone = true;
    process.release();
    return process;
  }

  /** Ends it where it was never let go. */
  @Override
  public void close() {
    if (!gone) {
      process.close();
      if (simulator != null) {
        simulator.close();
      }
    }
  }
}
