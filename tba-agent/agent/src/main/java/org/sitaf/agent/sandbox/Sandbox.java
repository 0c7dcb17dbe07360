package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.time.Duration;

/** A way to start processes of other people's code on this machine. Safe to use from threads. */
public sealed interface Sandbox permits NoSandbox, Bubblewrap {

  /** The kind of no sandbox at all. */
  String NONE = "none";

  /**
   * What it is, for the agent's capabilities, such as {@code bubblewrap 0.8.0} or {@link #NONE}.
   */
  String kind();

  /** What it is and why, for logs. */
  String description();

  /** Whether nothing of the user's may run outside of one. */
  boolean isRequired();

  /**
   * Starts a process; its input is at its end unless it is held back, its output and error stream
   * are the caller's.
   *
   * @throws IOException when it cannot be started
   */
  ConfinedProcess start(Confinement confinement) throws IOException;

  /**
   * Runs a tool to its end, as compilers are.
   *
   * @param atMost after this time it is killed, with all that it started
   * @throws IOException when it cannot be started
   * @throws InterruptedException when nobody waits for it any more; it is gone then
   */
  default ToolEnd run(Confinement confinement, Duration atMost)
      throws IOException, InterruptedException {
    return ToolEnd.of(start(confinement), atMost);
  }

  /** Processes as they are, with this user's rights. */
  static Sandbox none() {
    return new NoSandbox("switched off");
  }
}
