package org.sitaf.agent.toolchain.debug;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** A process of a test application that waits for a debugger. */
public interface Debuggee {
  /** Whether a debugger can attach now; later it stays so until one has attached. */
  boolean isReady();

  /**
   * The command of a debugger for a terminal, which stops in the method under test. It is started
   * in the {@link #folder}.
   *
   * @throws IOException if it cannot be prepared
   */
  List<String> debugger() throws IOException, InterruptedException;

  /** What another debugger, such as that of an IDE, needs to attach; one line each. */
  List<String> connection();

  /** The working folder of the debugger. */
  Path folder();

  /** Lets the process continue if it still waits, as when the debugger could not attach. */
  void letContinue();
}
