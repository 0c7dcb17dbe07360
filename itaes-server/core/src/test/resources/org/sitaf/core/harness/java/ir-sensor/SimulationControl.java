package sitaf.harness.getinfrareddata;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import org.sitaf.runtime.simulation.Simulation;

/** Simulation control (SC): sets up the virtual environment world/ir.world.yaml. */
final class SimulationControl {
  /** Simulation time before the call. */
  private static final Duration SETTLE = Duration.ZERO;

  private final Simulation simulation;

  SimulationControl(Simulation simulation) {
    this.simulation = simulation;
  }

  /**
   * Resets the world, sets the parameters of a case, and lets the world settle.
   *
   * @param distance Distance in m, from -1.0 to 20.0
   */
  void prepare(double distance) {
    Map<String, Double> parameters = new LinkedHashMap<>();
    parameters.put("Distance", distance);
    simulation.prepare(parameters, SETTLE);
  }
}
