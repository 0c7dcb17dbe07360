package sitaf.harness.getinfrareddata;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import org.sitaf.runtime.simulation.Simulation;

/** Simulation control (SC): sets the virtual environment that world/ir.world.yaml describes. */
final class SimulationControl {
  /** Simulation time that passes before the call. */
  private static final Duration SETTLE = Duration.ZERO;

  private final Simulation simulation;

  SimulationControl(Simulation simulation) {
    this.simulation = simulation;
  }

  /**
   * Puts the world into the state of a case, from a clean reset, and lets it settle.
   *
   * @param distance Distance in m, from -1.0 to 20.0
   */
  void prepare(double distance) {
    Map<String, Double> parameters = new LinkedHashMap<>();
    parameters.put("Distance", distance);
    simulation.prepare(parameters, SETTLE);
  }
}
