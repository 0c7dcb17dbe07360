package org.sitaf.runtime.simulation;

import java.util.HashMap;
import java.util.Map;
import org.sitaf.sim.v1.Observation;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.WorldState;

/** What the robot's devices read, and what can be observed, at one step. */
record FrozenWorld(Map<String, RangeReading> ranges, Map<String, Double> observations) {

  /** Metres; REP-117. */
  record RangeReading(double range, double min, double max) {}

  static FrozenWorld of(WorldState state) {
    Map<String, RangeReading> ranges = new HashMap<>();
    for (Reading reading : state.getReadingsList()) {
      if (reading.hasRange()) {
        ranges.put(
            reading.getDevice(),
            new RangeReading(
                reading.getRange().getRangeM(),
                reading.getRange().getMinRangeM(),
                reading.getRange().getMaxRangeM()));
      }
    }
    Map<String, Double> observations = new HashMap<>();
    for (Observation observation : state.getObservationsList()) {
      observations.put(observation.getName(), observation.getValue());
    }
    return new FrozenWorld(ranges, observations);
  }
}
