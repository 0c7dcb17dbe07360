package org.sitaf.examples.ir;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.RangeSensor;

/**
 * The infrared sensors of a robot, numbered from 1. The methods have the names of the interface
 * {@code InfraredSensorService}.
 */
public final class InfraredSensor {
  /** The value that {@link #GetInfraredData} returns if there is no distance. */
  public static final double NO_DISTANCE = -1.0;

  private final Hardware hardware;
  private final List<RangeSensor> sensors = new ArrayList<>();
  private int size = 1;

  /** Uses the range sensors {@code ir1}, {@code ir2} and so on. */
  public InfraredSensor(Hardware hardware) {
    this.hardware = hardware;
  }

  /** Property {@code Size}: the number of sensors, at least 1. */
  public void setSize(int size) {
    if (size < 1) {
      throw new IllegalArgumentException("Size must be at least 1, not " + size);
    }
    this.size = size;
  }

  /** Opens the sensors. Before this call, there is no distance. */
  public void Enable() {
    Disable();
    for (int i = 1; i <= size; i++) {
      sensors.add(hardware.rangeSensor("ir" + i));
    }
  }

  /** Releases the sensors. */
  public void Disable() {
    sensors.clear();
  }

  /** Whether the sensors are open. */
  public boolean IsEnabled() {
    return !sensors.isEmpty();
  }

  /**
   * Returns the distance that one sensor measures.
   *
   * @param indexOfSensor the number of the sensor, 1 to {@code numOfSensor}
   * @param numOfSensor the number of sensors that the caller uses, from 1 to the property {@code
   *     Size}
   * @return the distance in metres; {@link #NO_DISTANCE} if an argument is out of range or no object
   *     is within the range of the sensor
   */
  public double GetInfraredData(int indexOfSensor, int numOfSensor) {
    if (numOfSensor < 1 || numOfSensor > sensors.size()) {
      return NO_DISTANCE;
    }
    if (indexOfSensor < 1 || indexOfSensor > numOfSensor) {
      return NO_DISTANCE;
    }
    double range = sensors.get(indexOfSensor - 1).range();
    return Double.isFinite(range) ? range : NO_DISTANCE;
  }
}
