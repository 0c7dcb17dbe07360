package org.sitaf.agent.executor;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sitaf.agent.sandbox.Confinement;

/**
 * The address of the simulator of a test application.
 *
 * @param target gRPC target
 */
public record SimulatorAddress(String target) {
  private static final String UNIX = "unix:";

  /** What is appended to the path of a gRPC socket for its socket of operations. */
  private static final String OPERATIONS = ".ops";

  public SimulatorAddress {
    Objects.requireNonNull(target);
  }

  /** The Unix socket; empty if the simulator uses TCP. */
  public Optional<Path> socket() {
    if (!target.startsWith(UNIX)) {
      return Optional.empty();
    }
    String path = target.substring(UNIX.length());
    return Optional.of(Path.of(path.startsWith("//") ? path.substring(2) : path).toAbsolutePath());
  }

  /** Gives access to the simulator: the files of its Unix sockets, otherwise the network. */
  Confinement grantedTo(Confinement confinement) {
    return socket()
        .map(socket -> confinement.reading(sockets(socket)))
        .orElseGet(confinement::withNetwork);
  }

  private static List<Path> sockets(Path socket) {
    Path operations = socket.resolveSibling(socket.getFileName() + OPERATIONS);
    return Files.exists(operations) ? List.of(socket, operations) : List.of(socket);
  }
}
