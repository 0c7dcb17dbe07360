package org.sitaf.agent.executor;

import java.util.Map;

/**
 * How a process ended.
 *
 * @param code exit code; 128 plus the signal number for a signal, as in a shell
 * @param exceededLimit the limit that the agent killed it for; empty for none
 * @param lastLine the last relevant line of its error stream; empty if there is none
 */
record ProcessEnd(int code, String exceededLimit, String lastLine) {
  private static final int SIGNAL_BASE = 128;

  /**
   * Exit code of a test application that cannot continue, together with a line that starts with
   * {@link #REASON}.
   */
  private static final int CANNOT_CONTINUE = 3;

  private static final String REASON = "sitaf: ";

  /** Start of the reason if the simulator no longer answers. */
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
   * Whether the test application reported that it cannot continue; a component that exits with the
   * same code does not print the reason.
   */
  boolean cannotGoOn() {
    return code == CANNOT_CONTINUE && lastLine.startsWith(REASON);
  }

  /** Whether it cannot continue because it lost the simulator or its session. */
  boolean lostSimulator() {
    return cannotGoOn() && reason().startsWith(LOST_SIMULATOR);
  }

  /** The reason that the test application reported. */
  String reason() {
    return lastLine.startsWith(REASON) ? lastLine.substring(REASON.length()) : lastLine;
  }

  /** Text for messages, such as {@code signal 9 (SIGKILL)} or {@code exit code 1: last line}. */
  String describe() {
    if (!exceededLimit.isEmpty()) {
      return exceededLimit;
    }
    String signal = SIGNALS.get(code - SIGNAL_BASE);
    String how =
        signal == null
            ? "exit code " + code
            : "signal " + (code - SIGNAL_BASE) + " (" + signal + ")";
    return lastLine.isEmpty() ? how : how + ": " + lastLine;
  }
}
