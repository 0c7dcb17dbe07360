package org.sitaf.agent.executor;

import java.io.IOException;

/**
 * The first process of a test application, started while the application is still being compiled.
 * It is confined as any other and runs nothing of the user's until it is let go.
 */
public final class EarlyProcess implements AutoCloseable {
  private final HarnessProcess process;
  private final String simulatorTarget;
  private boolean gone;

  private EarlyProcess(HarnessProcess process, String simulatorTarget) {
    this.process = process;
    this.simulatorTarget = simulatorTarget;
  }

  /**
   * Starts it.
   *
   * @param request as it will be executed, with an application that was opened early
   * @throws IOException when it cannot be started, or its simulator is not there
   */
  public static EarlyProcess start(ExecutionRequest request, OutputSink sink)
      throws IOException, InterruptedException {
    int first = request.suite().cases().get(0).no();
    String target = request.simulatorTarget();
    return new EarlyProcess(HarnessProcess.startHeldBack(request, first, sink), target);
  }

  String simulatorTarget() {
    return simulatorTarget;
  }

  /** The process, which now goes on; whoever takes it closes it. */
  HarnessProcess letGo() {
    gone = true;
    process.letGo();
    return process;
  }

  /** Ends it where it was never let go. */
  @Override
  public void close() {
    if (!gone) {
      process.close();
    }
  }
}
