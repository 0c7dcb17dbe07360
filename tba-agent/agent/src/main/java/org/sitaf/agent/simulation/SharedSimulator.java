package org.sitaf.agent.simulation;

import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.HardwareReport;

/**
 * A simulator that other builds use, too. A bridge that was started with {@code --endpoints} opens
 * an endpoint for each process of the build, which samples signals; with any other one, all
 * processes make their calls at its own address.
 */
final class SharedSimulator implements BuildSimulator {
  private static final SecureRandom RANDOM = new SecureRandom();

  private static final String UNIX = "unix:";

  /** Names are shared with other builds; 16 characters of base 32 are the longest ones. */
  private static final int NAME_BITS = 80;

  private static final int NAME_BASE = 32;

  private final String target;
  private final SimulatorClient client;
  private final Set<OwnEndpoint> open = ConcurrentHashMap.newKeySet();
  private @Nullable Boolean opensEndpoints;
  private String digest = "";
  private @Nullable SignalOrder signals;

  SharedSimulator(String target) {
    this.target = target;
    this.client = new SimulatorClient(target);
  }

  @Override
  public String description() {
    return "the simulator at " + target + " is shared with others";
  }

  @Override
  public String version() throws SimulatorException {
    return client.version();
  }

  @Override
  public synchronized long check(String description, Map<String, byte[]> files, Set<String> faults)
      throws WorldException, SimulatorException {
    CompiledWorld compiled = client.check(description, files, faults);
    digest = compiled.digest();
    return compiled.stepNanos();
  }

  @Override
  public synchronized void sample(SignalOrder order) throws SimulatorException {
    if (!opensEndpoints()) {
      throw new SimulatorException(
          "signals and trajectory conditions need a simulator that opens endpoints for a build,"
              + " and the one at "
              + target
              + " does not; start it with --endpoints FOLDER");
    }
    signals = order;
  }

  private boolean opensEndpoints() throws SimulatorException {
    Boolean known = opensEndpoints;
    if (known == null) {
      known = client.opensEndpoints();
      opensEndpoints = known;
    }
    return known;
  }

  @Override
  public Optional<Trace> takeSignals(int no) throws SimulatorException {
    for (OwnEndpoint endpoint : open) {
      Optional<Trace> trace = client.takeSignals(endpoint.name(), no);
      if (trace.isPresent()) {
        return trace;
      }
    }
    return Optional.empty();
  }

  @Override
  public Optional<LiveMotion.Motion> motion(long known) throws SimulatorException {
    for (OwnEndpoint endpoint : open) {
      Optional<LiveMotion.Motion> motion = client.motion(endpoint.name(), known);
      if (motion.isPresent()) {
        return motion;
      }
    }
    return Optional.empty();
  }

  @Override
  public List<String> use(HardwareOrder order) throws SimulatorException {
    throw new SimulatorException(
        "real and recorded devices need a simulator that serves this build only, but the one at "
            + target
            + " is shared with others");
  }

  @Override
  public @Nullable HardwareReport takeHardwareReport(int no) {
    return null;
  }

  @Override
  public synchronized SimulatorEndpoint open() throws SimulatorException {
    if (!opensEndpoints()) {
      return new Everyones(target);
    }
    if (digest.isEmpty()) {
      throw new IllegalStateException("the world was not checked");
    }
    String name = new BigInteger(NAME_BITS, RANDOM).toString(NAME_BASE);
    String address = client.openEndpoint(name, digest, signals, null);
    OwnEndpoint opened = new OwnEndpoint(client, name, address, open);
    open.add(opened);
    if (address.startsWith(UNIX) && !Files.exists(Path.of(address.substring(UNIX.length())))) {
      opened.close();
      throw new SimulatorException(
          "the simulator at "
              + target
              + " opens its endpoints at "
              + address
              + ", which is not on this machine; use a simulator that runs here");
    }
    return opened;
  }

  @Override
  public String target() {
    return target;
  }

  @Override
  public void close() {
    client.close();
  }

  /** An endpoint of one process of the build. */
  private record OwnEndpoint(
      SimulatorClient client, String name, String target, Set<OwnEndpoint> open)
      implements SimulatorEndpoint {
    @Override
    public boolean equals(@Nullable Object other) {
      return this == other;
    }

    @Override
    public int hashCode() {
      return name.hashCode();
    }

    @Override
    public boolean isShared() {
      return false;
    }

    @Override
    public boolean hasEnded() {
      // Only a call shows it.
      return false;
    }

    @Override
    public Optional<SimulatorEnd> end() {
      try {
        client.requireAnswer();
        return Optional.empty();
      } catch (SimulatorException e) {
        return Optional.of(new SimulatorEnd(String.valueOf(e.getMessage()), false));
      }
    }

    @Override
    public void close() {
      open.remove(this);
      boolean unused = client.closesEndpoint(name);
    }
  }

  /** The address that all builds use. */
  private record Everyones(String target) implements SimulatorEndpoint {
    @Override
    public boolean isShared() {
      return true;
    }

    @Override
    public boolean hasEnded() {
      return false;
    }

    @Override
    public Optional<SimulatorEnd> end() {
      return Optional.empty();
    }

    @Override
    public void close() {}
  }
}
