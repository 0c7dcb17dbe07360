package org.sitaf.runtime.simulation;

import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.RangeSensor;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.simulation.FrozenWorld.RangeReading;

/**
 * The devices of a simulated robot. Readings come from the frozen world that the last step left,
 * without a round trip.
 */
final class SimulatedHardware implements Hardware {
  private final Map<String, String> kinds;
  private final Stopwatch stopwatch;
  private volatile FrozenWorld world;

  /**
   * The devices of a world.
   *
   * @param kinds kind of each device, by name
   */
  SimulatedHardware(Map<String, String> kinds, Stopwatch stopwatch, FrozenWorld world) {
    this.kinds = Collections.unmodifiableMap(new TreeMap<>(kinds));
    this.stopwatch = stopwatch;
    this.world = world;
  }

  void freeze(FrozenWorld newWorld) {
    world = newWorld;
  }

  @Override
  public Set<String> devices() {
    return kinds.keySet();
  }

  @Override
  public RangeSensor rangeSensor(String name) {
    long entered = stopwatch.enter();
    try {
      String kind = kinds.get(name);
      if (kind == null) {
        throw new IllegalArgumentException(
            "the robot has no device '" + name + "'; it has " + kinds.keySet());
      }
      if (!kind.equals("range")) {
        throw new IllegalArgumentException(
            "device '" + name + "' is of kind " + kind + ", not a range sensor");
      }
      return new SimulatedRangeSensor(name);
    } finally {
      stopwatch.leaveHardware(entered);
    }
  }

  private final class SimulatedRangeSensor implements RangeSensor {
    private final String name;

    SimulatedRangeSensor(String name) {
      this.name = name;
    }

    @Override
    public String name() {
      return name;
    }

    @Override
    public double range() {
      return reading().range();
    }

    @Override
    public double minRange() {
      return reading().min();
    }

    @Override
    public double maxRange() {
      return reading().max();
    }

    private RangeReading reading() {
      long entered = stopwatch.enter();
      try {
        RangeReading reading = world.ranges().get(name);
        return reading == null ? new RangeReading(Double.NaN, Double.NaN, Double.NaN) : reading;
      } finally {
        stopwatch.leaveHardware(entered);
      }
    }
  }
}
