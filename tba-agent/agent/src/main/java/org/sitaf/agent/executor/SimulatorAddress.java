package org.sitaf.agent.executor;

import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sitaf.agent.sandbox.Confinement;

/**
 * Where a test application reaches the simulator.
 *
 * @param target as gRPC names it
 */
public record SimulatorAddress(String target) {
  private static final String UNIX = "unix:";

  public SimulatorAddress {
    Objects.requireNonNull(target);
  }

  /** The Unix socket; empty where the simulator answers on the network. */
  public Optional<Path> socket() {
    if (!target.startsWith(UNIX)) {
      return Optional.empty();
    }
    String path = target.substring(UNIX.length());
    return Optional.of(Path.of(path.startsWith("//") ? path.substring(2) : path).toAbsolutePath());
  }

  /** With the way to the simulator open: one file where it is a socket, else the network. */
  Confinement grantedTo(Confinement confinement) {
    return socket()
        .map(socket -> confinement.reading(List.of(socket)))
        .orElseGet(confinement::withNetwork);
  }
}
