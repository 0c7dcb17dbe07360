package org.sitaf.agent.executor;

import java.util.Map;

/**
 * How a process ended.
 *
 * @param code exit code; above 128 a signal's number is added, as shells have it
 * @param exceededLimit for which limit the agent ended it; empty where it did not
 * @param lastWords the last telling line of its standard error; empty where it said nothing
 */
record ProcessEnd(int code, String exceededLimit, String lastWords) {
  private static final int SIGNAL_BASE = 128;

  /**
   * What a harness returns that cannot go on, together with a line that begins with {@link
   * #REASON}.
   */
  private static final int CANNOT_GO_ON = 3;

  private static final String REASON = "sitaf: ";

  /** How a harness begins the reason when its simulator does not answer any more. */
  private static final String LOST_SIMULATOR = "the simulator is gone: ";

  private static final Map<Integer, String> SIGNALS =
      Map.ofEntries(
          Map.entry(1, "SIGHUP"),
          Map.entry(2, "SIGINT"),
          Map.entry(3, "SIGQUIT"),
          Map.entry(4, "SIGILL"),
          Map.entry(6, "SIGABRT"),
          Map.entry(7, "SIGBUS"),
          Map.entry(8, "SIGFPE"),
          Map.entry(9, "SIGKILL"),
          Map.entry(11, "SIGSEGV"),
          Map.entry(13, "SIGPIPE"),
          Map.entry(15, "SIGTERM"),
          Map.entry(24, "SIGXCPU"),
          Map.entry(31, "SIGSYS"));

  /**
   * Whether the test application says itself that it cannot go on; a component that exits with the
   * same code does not.
   */
  boolean cannotGoOn() {
    return code == CANNOT_GO_ON && lastWords.startsWith(REASON);
  }

  /** Whether it cannot go on because the simulator or its session is gone. */
  boolean lostSimulator() {
    return cannotGoOn() && reason().startsWith(LOST_SIMULATOR);
  }

  /** The reason that the test application gave. */
  String reason() {
    return lastWords.startsWith(REASON) ? lastWords.substring(REASON.length()) : lastWords;
  }

  /**
   * As a message shows it, such as {@code signal 9 (SIGKILL)} or {@code exit code 1: last words}.
   */
  String describe() {
    if (!exceededLimit.isEmpty()) {
      return exceededLimit;
    }
    String signal = SIGNALS.get(code - SIGNAL_BASE);
    String how =
        signal == null
            ? "exit code " + code
            : "signal " + (code - SIGNAL_BASE) + " (" + signal + ")";
    return lastWords.isEmpty() ? how : how + ": " + lastWords;
  }
}
