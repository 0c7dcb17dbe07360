package org.sitaf.runtime.simulation.frozen;

import java.util.List;
import java.util.Map;
import org.sitaf.sim.v1.Reading;

/** A world as a row of numbers; readings are converted to messages on demand. */
record PreparedWorld(long timeNanos, Layout layout, List<Double> row) implements FrozenWorld {
  @Override
  public Reading reading(String device) {
    return layout.reading(device, row);
  }

  @Override
  public Map<String, Double> observations() {
    return layout.observations(row);
  }
}
