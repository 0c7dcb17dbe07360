package org.sitaf.agent.executor;

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

  /** Gives access to the simulator: one file for a Unix socket, otherwise the network. */
  Confinement grantedTo(Confinement confinement) {
    return socket()
        .map(socket -> confinement.reading(List.of(socket)))
        .orElseGet(confinement::withNetwork);
  }
}
