package org.sitaf.cli.terminal;

import java.io.Console;
import java.io.PrintStream;
import java.util.function.LongSupplier;

/**
 * A line that shows the current step: updated in place on a terminal, otherwise one line per step
 * and, while cases run, one line every 10 seconds.
 */
public final class ProgressLine implements AutoCloseable {
  private static final long PERIOD_NANOS = 10_000_000_000L;

  private final PrintStream out;
  private final boolean isTerminal;
  private final LongSupplier nanos;
  private String shown = "";
  private boolean dirty;
  private long began;
  private long printed;

  /** Writes to a stream for people, usually standard error. */
  public ProgressLine(PrintStream out) {
    this(
        out,
        System.console() instanceof Console && !"dumb".equals(System.getenv("TERM")),
        System::nanoTime);
  }

  /**
   * Writes to a stream for people.
   *
   * @param nanos a clock in nanoseconds
   */
  ProgressLine(PrintStream out, boolean isTerminal, LongSupplier nanos) {
    this.out = out;
    this.isTerminal = isTerminal;
    this.nanos = nanos;
    this.began = nanos.getAsLong();
    this.printed = began;
  }

  /** Shows the start of a step. */
  public synchronized void step(String text) {
    if (isTerminal) {
      show(text);
    } else if (!text.equals(shown)) {
      out.println(text);
    }
    shown = text;
    began = nanos.getAsLong();
    printed = began;
  }

  /** Shows the progress of the step, on a terminal only. */
  public synchronized void detail(String text) {
    if (isTerminal) {
      show(shown.isEmpty() ? text : shown + ": " + text);
      dirty = true;
    }
  }

  /**
   * Shows how many parts of the step are done, and how long the others will take if they take as
   * long on average.
   */
  public synchronized void done(int done, int total) {
    long now = nanos.getAsLong();
    long left = done == 0 ? 0 : Math.round((double) (now - began) / done * (total - done) / 1e9);
    String text = done + "/" + total + (left < 1 ? "" : ", about " + duration(left) + " left");
    if (isTerminal) {
      detail(text);
    } else if (now - printed >= PERIOD_NANOS && done < total) {
      out.println(shown.isEmpty() ? text : shown + ": " + text);
      printed = now;
    }
  }

  private static String duration(long seconds) {
    return seconds < 120
        ? seconds + " s"
        : seconds < 7_200
            ? Math.round(seconds / 60.0) + " min"
            : Math.round(seconds / 3600.0) + " h";
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
