package org.sitaf.runtime.simulation;

import java.util.HashMap;
import java.util.Map;
import org.sitaf.sim.v1.Observation;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.WorldState;

/** What the robot's devices read, and what can be observed, at one step. */
record FrozenWorld(
    long timeNanos, Map<String, Reading> readings, Map<String, Double> observations) {

  static FrozenWorld of(WorldState state) {
    Map<String, Reading> readings = new HashMap<>();
    for (Reading reading : state.getReadingsList()) {
      readings.put(reading.getDevice(), reading);
    }
    Map<String, Double> observations = new HashMap<>();
    for (Observation observation : state.getObservationsList()) {
      observations.put(observation.getName(), observation.getValue());
    }
    return new FrozenWorld(state.getTimeNs(), readings, observations);
  }
}
