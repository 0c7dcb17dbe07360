package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;

/** A Python process whose debugger, pdb, talks through a Unix socket. */
record PythonDebuggee(DebugPlace place, Path python) implements Debuggee {
  private static final String SOCKET = "pdb";

  private Path socket() {
    return place.folder().resolve(SOCKET);
  }

  @Override
  public boolean isReady() {
    return Files.exists(socket());
  }

  @Override
  public List<String> debugger() {
    return List.of(
        python.toString(),
        "-s",
        "-P",
        "-m",
        "sitaf_runtime.debugging.terminal",
        socket().toString());
  }

  @Override
  public List<String> connection() {
    return List.of(
        "connect a terminal to pdb: " + String.join(" ", debugger()),
        "or any program that exchanges lines with the Unix socket " + socket());
  }

  @Override
  public Path folder() {
    return place.folder();
  }

  @Override
  public void letContinue() {
    try (SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX)) {
      channel.connect(UnixDomainSocketAddress.of(socket()));
    } catch (IOException e) {
      // A terminal was connected, or the process has ended.
    }
  }
}
