package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.time.Duration;

/** Starts processes of untrusted code on this machine. Thread-safe. */
public sealed interface Sandbox permits NoSandbox, Bubblewrap {

  /** The kind of sandbox if there is none. */
  String NONE = "none";

  /**
   * Name and version, reported as a capability of the agent, such as {@code bubblewrap 0.8.0} or
   * {@link #NONE}.
   */
  String kind();

  /** A description for logs, with the reason for missing features. */
  String description();

  /** Whether the user requires a sandbox. */
  boolean isRequired();

  /** Whether processes can leave the processors to others ({@link ConfinedProcess#setIdle}). */
  boolean canIdle();

  /**
   * Starts a process. Its input is empty unless {@link Confinement#keepsInputOpen}; the caller
   * reads its output and error stream.
   *
   * @throws IOException if it cannot be started
   */
  ConfinedProcess start(Confinement confinement) throws IOException;

  /**
   * Runs a tool, such as a compiler, until it ends.
   *
   * @param atMost timeout after which the tool and all that it started are killed
   * @throws IOException if it cannot be started
   * @throws InterruptedException if the thread is interrupted; the tool is killed
   */
  default ToolResult run(Confinement confinement, Duration atMost)
      throws IOException, InterruptedException {
    return ToolResult.of(start(confinement), atMost);
  }

  /** Starts processes without a sandbox, with this user's rights. */
  static Sandbox none() {
    return new NoSandbox("switched off");
  }
}
