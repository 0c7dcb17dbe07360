package org.sitaf.cli.terminal;

import sun.misc.Signal;
import sun.misc.SignalHandler;

/** Ignores Ctrl-C while another program in the same terminal handles it. */
public final class Interrupts implements AutoCloseable {
  private final Signal signal = new Signal("INT");
  private final SignalHandler before;

  private Interrupts() {
    // A handler, not SIG_IGN: child processes inherit an ignored signal.
    before = Signal.handle(signal, s -> {});
  }

  /** Ignores Ctrl-C until this is closed. */
  public static Interrupts ignored() {
    return new Interrupts();
  }

  @Override
  public void close() {
    Signal.handle(signal, before);
  }
}
