package org.sitaf.agent.executor;

import org.sitaf.agent.simulation.SimulatorEnd;

/**
 * Decides what follows when a simulator ended while a case ran. One that used more than it may did
 * so because of the case. Any other end may be the machine's doing once, and not twice in the same
 * case.
 */
final class SimulatorEnds {
  /** What happens next. */
  enum Next {
    TRY_AGAIN,
    BLAME_CASE,
    GIVE_UP
  }

  /**
   * What follows.
   *
   * @param message for the log, or of the case's result
   */
  record Consequence(Next next, String message) {}

  private final int mostInACase;
  private final int mostRestarts;
  private int lastCase;
  private int inLastCase;
  private int restarts;

  SimulatorEnds(int mostInACase, int mostRestarts) {
    this.mostInACase = mostInACase;
    this.mostRestarts = mostRestarts;
  }

  /**
   * Counts one end.
   *
   * @param no of the case that ran, or would have been the first
   * @param begun whether the test application had begun with its cases
   */
  Consequence after(int no, boolean begun, SimulatorEnd end) {
    restarts++;
    inLastCase = no == lastCase ? inLastCase + 1 : 1;
    lastCase = no;
    String message = "the simulator ended: " + end.reason();
    if (restarts > mostRestarts) {
      return new Consequence(
          Next.GIVE_UP, message + "; it ended " + restarts + " times in this build");
    }
    if (begun && end.byLimit()) {
      return new Consequence(Next.BLAME_CASE, "case " + no + ": " + message);
    }
    if (begun && inLastCase >= mostInACase) {
      return new Consequence(
          Next.BLAME_CASE,
          "case " + no + ": " + message + "; it ended each time that this case ran");
    }
    return new Consequence(Next.TRY_AGAIN, message + "; going on with a fresh one");
  }
}
