package org.sitaf.agent.toolchain.debug;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Where a process and its debugger find each other.
 *
 * @param folder absolute folder of this process, empty at first; working folder of the debugger
 * @param port free TCP port of the loopback interface
 */
public record DebugPlace(DebugOrder order, Path folder, int port) {
  /** Environment variable for the runtimes of C++ and Python: the folder. */
  public static final String VARIABLE = "SITAF_DEBUGGER";

  /** Environment variable for the runtime of Python: the port, for another debugger. */
  public static final String PORT = "SITAF_DEBUGGER_PORT";

  /** Name of the pipe in the folder. */
  public static final String PIPE = "go";

  public DebugPlace {
    Objects.requireNonNull(order);
    Objects.requireNonNull(folder);
  }

  /**
   * Creates a place for one process.
   *
   * @param parent folder in which its folder is created
   */
  public static DebugPlace in(Path parent, DebugOrder order)
      throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory(parent, "debug");
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      DebugPlace place = new DebugPlace(order, folder, free.getLocalPort());
      place.createPipe();
      return place;
    }
  }

  /** A named pipe, which a process may open to wait for its debugger. */
  public Path pipe() {
    return folder.resolve(PIPE);
  }

  private void createPipe() throws IOException, InterruptedException {
    Process made =
        new ProcessBuilder("mkfifo", "-m", "600", pipe().toString())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    if (made.waitFor() != 0) {
      throw new IOException("mkfifo could not create " + pipe() + "; it is part of coreutils");
    }
  }
}
