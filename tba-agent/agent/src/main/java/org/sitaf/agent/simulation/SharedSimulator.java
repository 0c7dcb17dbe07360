package org.sitaf.agent.simulation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.HardwareReport;

/** A simulator that other builds use, too. */
final class SharedSimulator implements BuildSimulator {
  private final String target;
  private final SimulatorClient client;

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
  public long check(String description, Map<String, byte[]> files, Set<String> faults)
      throws WorldException, SimulatorException {
    return client.check(description, files, faults).stepNanos();
  }

  @Override
  public void sample(SignalOrder order) throws SimulatorException {
    throw new SimulatorException(
        "trajectory conditions need a simulator that serves this build only, but the one at "
            + target
            + " is shared with others");
  }

  @Override
  public Optional<Trace> takeSignals(int no) {
    return Optional.empty();
  }

  @Override
  public Optional<LiveMotion.Motion> motion(long known) {
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
  public SimulatorEndpoint open() {
    return new Endpoint();
  }

  @Override
  public String target() {
    return target;
  }

  @Override
  public void close() {
    client.close();
  }

  private final class Endpoint implements SimulatorEndpoint {
    @Override
    public String target() {
      return target;
    }

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
