package org.sitaf.agent.executor;

import org.sitaf.agent.simulation.SimulatorEnd;

/**
 * Decides how to continue when the simulator ended while a case ran. Exceeding a limit is the fault
 * of the case. Any other end is retried once in the same case.
 */
final class SimulatorEnds {
  /** How to continue. */
  enum Next {
    TRY_AGAIN,
    BLAME_CASE,
    GIVE_UP
  }

  /**
   * The decision.
   *
   * @param message for the log or the case's result
   */
  record Consequence(Next next, String message) {}

  private final int maxPerCase;
  private final int maxRestarts;
  private int lastCase;
  private int endsInLastCase;
  private int restarts;

  SimulatorEnds(int maxPerCase, int maxRestarts) {
    this.maxPerCase = maxPerCase;
    this.maxRestarts = maxRestarts;
  }

  /**
   * Counts an end of the simulator.
   *
   * @param no number of the running case, or of the first one
   * @param begun whether the test application had started its cases
   */
  Consequence after(int no, boolean begun, SimulatorEnd end) {
    restarts++;
    endsInLastCase = no == lastCase ? endsInLastCase + 1 : 1;
    lastCase = no;
    String message = "the simulator ended: " + end.reason();
    if (restarts > maxRestarts) {
      return new Consequence(
          Next.GIVE_UP, message + "; it ended " + restarts + " times in this build");
    }
    if (begun && end.byLimit()) {
      return new Consequence(Next.BLAME_CASE, "case " + no + ": " + message);
    }
    if (begun && endsInLastCase >= maxPerCase) {
      return new Consequence(
          Next.BLAME_CASE, "case " + no + ": " + message + "; it ended each time in this case");
    }
    return new Consequence(Next.TRY_AGAIN, message + "; continuing with a new one");
  }
}
