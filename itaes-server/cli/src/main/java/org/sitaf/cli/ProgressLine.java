package org.sitaf.cli;

import java.io.Console;
import java.io.PrintStream;

/**
 * A line that shows the current step: updated in place on a terminal, otherwise one line per step.
 */
public final class ProgressLine implements AutoCloseable {
  private final PrintStream out;
  private final boolean isTerminal;
  private String shown = "";
  private boolean dirty;

  /** Writes to a stream for people, usually standard error. */
  public ProgressLine(PrintStream out) {
    this.out = out;
    Console console = System.console();
    this.isTerminal = console != null && !"dumb".equals(System.getenv("TERM"));
  }

  /** Shows the start of a step. */
  public synchronized void step(String text) {
    if (isTerminal) {
      show(text);
    } else if (!text.equals(shown)) {
      out.println(text);
    }
    shown = text;
  }

  /** Shows the progress of the step, on a terminal only. */
  public synchronized void detail(String text) {
    if (isTerminal) {
      show(shown.isEmpty() ? text : shown + ": " + text);
      dirty = true;
    }
  }

  private void show(String text) {
    out.print("\r\033[K" + Printable.line(text));
    out.flush();
  }

  @Override
  public synchronized void close() {
    if (isTerminal && (dirty || !shown.isEmpty())) {
      out.print("\r\033[K");
      out.flush();
    }
  }
}
