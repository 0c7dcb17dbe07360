package org.sitaf.cli;

import java.io.Console;
import java.io.PrintStream;

/**
 * One line that says what is being done: it moves on a terminal, and is a line a step elsewhere.
 */
public final class ProgressLine implements AutoCloseable {
  private final PrintStream out;
  private final boolean moving;
  private String shown = "";
  private boolean dirty;

  /** Writes to a stream that people read, standard error as a rule. */
  public ProgressLine(PrintStream out) {
    this.out = out;
    Console console = System.console();
    this.moving = console != null && !"dumb".equals(System.getenv("TERM"));
  }

  /** A step that began. */
  public synchronized void step(String text) {
    if (moving) {
      show(text);
    } else if (!text.equals(shown)) {
      out.println(text);
    }
    shown = text;
  }

  /** How far the step is; seen on a terminal only. */
  public synchronized void detail(String text) {
    if (moving) {
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
    if (moving && (dirty || !shown.isEmpty())) {
      out.print("\r\033[K");
      out.flush();
    }
  }
}
