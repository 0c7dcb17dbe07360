package org.sitaf.cli.debug;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.debug.Debuggee;
import org.sitaf.cli.terminal.Interrupts;
import org.sitaf.cli.terminal.Printable;

/**
 * Starts a debugger in this terminal when the process of a test application waits for one, or
 * prints how another one attaches.
 */
public final class DebugSession implements AutoCloseable {
  private static final Duration POLL = Duration.ofMillis(10);

  private final boolean printOnly;
  private final PrintWriter err;
  private final Interrupts interrupts = Interrupts.ignored();
  private @Nullable Thread thread;
  private @Nullable Process debugger;
  private boolean caseEnded;

  /**
   * Creates a session. Until it is closed, Ctrl-C is for the debugger only, unless none is started.
   *
   * @param printOnly whether another debugger is used
   */
  public DebugSession(boolean printOnly, PrintWriter err) {
    this.printOnly = printOnly;
    this.err = err;
    if (printOnly) {
      interrupts.close();
    }
  }

  /** Whether another debugger is used. */
  public boolean isPrintOnly() {
    return printOnly;
  }

  /** Attaches to a process, in another thread. */
  public synchronized void attach(Debuggee debuggee) {
    thread = new Thread(() -> run(debuggee), "sitaf-debugger");
    thread.setDaemon(true);
    thread.start();
  }

  private void run(Debuggee debuggee) {
    try {
      while (!debuggee.isReady()) {
        if (hasCaseEnded()) {
          return;
        }
        Thread.sleep(POLL.toMillis());
      }
      if (printOnly) {
        debuggee.connection().forEach(this::print);
        print("the component waits for the debugger; end this command with Ctrl-C");
        return;
      }
      try {
        start(debuggee).waitFor();
      } finally {
        debuggee.letContinue();
      }
    } catch (IOException | RuntimeException e) {
      print("the debugger cannot be used: " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private Process start(Debuggee debuggee) throws IOException, InterruptedException {
    Process started =
        new ProcessBuilder(debuggee.debugger())
            .directory(debuggee.folder().toFile())
            .inheritIO()
            .start();
    synchronized (this) {
      debugger = started;
    }
    return started;
  }

  private void print(String line) {
    err.println(Printable.line(line));
    err.flush();
  }

  private synchronized boolean hasCaseEnded() {
    return caseEnded;
  }

  /** The case has ended: waits until the user leaves the debugger. */
  public void awaitEnd() throws InterruptedException {
    Thread waiting;
    synchronized (this) {
      caseEnded = true;
      waiting = thread;
    }
    if (waiting != null) {
      waiting.join();
    }
  }

  /** Ends the debugger. */
  @Override
  public void close() {
    synchronized (this) {
      caseEnded = true;
      if (debugger != null) {
        Objects.requireNonNull(debugger).destroy();
      }
    }
    interrupts.close();
  }
}
