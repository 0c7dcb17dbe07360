package org.sitaf.runtime.simulation.frozen;

import java.util.HashMap;
import java.util.Map;
import org.sitaf.sim.v1.Observation;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.WorldState;

/** What the robot's devices read, and what can be observed, at one step. */
public sealed interface FrozenWorld permits FrozenWorld.Told, PreparedWorld {
  /** Simulation time since the case was reset. */
  long timeNanos();

  /** What a device reads; an empty reading where it reads nothing. */
  Reading reading(String device);

  /** Values by the names of the observations, in the unit of each. */
  Map<String, Double> observations();

  /** A world as a message of the simulator tells it. */
  record Told(long timeNanos, Map<String, Reading> readings, Map<String, Double> observations)
      implements FrozenWorld {
    @Override
    public Reading reading(String device) {
      return readings.getOrDefault(device, Reading.getDefaultInstance());
    }
  }

  /** The world of a message. */
  static FrozenWorld of(WorldState state) {
    Map<String, Reading> readings = new HashMap<>();
    for (Reading reading : state.getReadingsList()) {
      readings.put(reading.getDevice(), reading);
    }
    Map<String, Double> observations = new HashMap<>();
    for (Observation observation : state.getObservationsList()) {
      observations.put(observation.getName(), observation.getValue());
    }
    return new Told(state.getTimeNs(), readings, observations);
  }
}
