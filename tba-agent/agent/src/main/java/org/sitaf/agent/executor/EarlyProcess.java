package org.sitaf.agent.executor;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.simulation.SimulatorEndpoint;

/**
 * The first process of a test application, started while the application is compiled. It runs in
 * the sandbox and executes no code of the user until it is released.
 */
public final class EarlyProcess implements AutoCloseable {
  private final HarnessProcess process;
  private final @Nullable SimulatorEndpoint simulator;
  private boolean released;

  private EarlyProcess(HarnessProcess process, @Nullable SimulatorEndpoint simulator) {
    this.process = process;
    this.simulator = simulator;
  }

  /**
   * Starts the process.
   *
   * @param request the later execution, with an application that was opened early
   * @throws IOException if the process or its simulator cannot be started
   */
  public static EarlyProcess start(ExecutionRequest request, OutputSink sink)
      throws IOException, InterruptedException {
    int first = request.suite().cases().get(0).no();
    SimulatorEndpoint simulator = request.newEndpoint();
    try {
      return new EarlyProcess(
          HarnessProcess.startWaiting(request, first, simulator, sink), simulator);
    } catch (IOException | InterruptedException | RuntimeException e) {
      if (simulator != null) {
        simulator.close();
      }
      throw e;
    }
  }

  /** Its simulator endpoint; closed by the caller of {@link #release}. */
  @Nullable SimulatorEndpoint simulator() {
    return simulator;
  }

  /** Lets the process continue and hands it over; the caller closes it. */
  HarnessProcess release() {
    released = true;
    process.release();
    return process;
  }

  /** Ends the process unless it was released. */
  @Override
  public void close() {
    if (!released) {
      process.close();
      if (simulator != null) {
        simulator.close();
      }
    }
  }
}
