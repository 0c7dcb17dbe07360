package org.sitaf.runtime.simulation.frozen;

import java.util.HashMap;
import java.util.Map;
import org.sitaf.sim.v1.Observation;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.WorldState;

/** Readings of all devices and observations at one step. */
public sealed interface FrozenWorld permits FrozenWorld.ReceivedWorld, PreparedWorld {
  /** Simulation time since the reset of the case. */
  long timeNanos();

  /** The reading of a device; an empty message when there is none. */
  Reading reading(String device);

  /** Values of the observations by name, in the unit of each. */
  Map<String, Double> observations();

  /** A world from a message of the simulator. */
  record ReceivedWorld(
      long timeNanos, Map<String, Reading> readings, Map<String, Double> observations)
      implements FrozenWorld {
    @Override
    public Reading reading(String device) {
      return readings.getOrDefault(device, Reading.getDefaultInstance());
    }
  }

  /** Reads the world from a message. */
  static FrozenWorld of(WorldState state) {
    Map<String, Reading> readings = new HashMap<>();
    for (Reading reading : state.getReadingsList()) {
      readings.put(reading.getDevice(), reading);
    }
    Map<String, Double> observations = new HashMap<>();
    for (Observation observation : state.getObservationsList()) {
      observations.put(observation.getName(), observation.getValue());
    }
    return new ReceivedWorld(state.getTimeNs(), readings, observations);
  }
}
