package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;

/**
 * A Python process whose debugger, pdb, talks through a Unix socket, and which an IDE can debug
 * with debugpy if the component's environment has it.
 *
 * @param sources copies of folders of the activity, with their paths there
 */
record PythonDebuggee(DebugPlace place, Path python, Map<Path, String> sources)
    implements Debuggee {
  private static final String SOCKET = "pdb";

  /** The runtime creates it when debugpy listens. */
  private static final String DEBUGPY = "debugpy";

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
    boolean forIde = Files.exists(place.folder().resolve(DEBUGPY));
    List<String> lines = new ArrayList<>();
    if (forIde) {
      lines.add("attach an IDE with debugpy to host 127.0.0.1, port " + place.port());
      sources.forEach(
          (copy, source) -> {
            Path original = place.order().activity().resolve(source).normalize();
            lines.add("path mapping: " + original + " -> " + copy);
          });
    }
    lines.add((forIde ? "or " : "") + "connect a terminal to pdb: " + String.join(" ", debugger()));
    lines.add("or any program that exchanges lines with the Unix socket " + socket());
    if (!forIde) {
      lines.add("for an IDE, add debugpy to the activity's requirements.txt");
    }
    return lines;
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
