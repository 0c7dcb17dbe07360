package org.sitaf.examples.ir;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.RangeSensor;

/**
 * The infrared sensors of a robot, side by side and numbered from 1. Methods are named as the
 * interface {@code InfraredSensorService} has them.
 */
public final class InfraredSensor {
  /** What {@link #GetInfraredData} returns where there is no distance to return. */
  public static final double NO_DISTANCE = -1.0;

  private final Hardware hardware;
  private final List<RangeSensor> sensors = new ArrayList<>();
  private int size = 1;

  /** The sensors of a robot; {@code ir1}, {@code ir2} and so on are their devices. */
  public InfraredSensor(Hardware hardware) {
    this.hardware = hardware;
  }

  /** Property {@code Size}: how many sensors there are. */
  public void setSize(int size) {
    if (size < 1) {
      throw new IllegalArgumentException("Size must be at least 1, not " + size);
    }
    this.size = size;
  }

  /** Finds the sensors. Until then nothing is measured. */
  public void Enable() {
    Disable();
    for (int i = 1; i <= size; i++) {
      sensors.add(hardware.rangeSensor("ir" + i));
    }
  }

  /** Lets the sensors go. */
  public void Disable() {
    sensors.clear();
  }

  /** Whether the sensors measure. */
  public boolean IsEnabled() {
    return !sensors.isEmpty();
  }

  /**
   * The distance that one sensor measures.
   *
   * @param indexOfSensor which sensor, from 1
   * @param numOfSensor how many sensors the caller uses, from 1 to {@code Size}; the index must be
   *     among them
   * @return the distance in metres; {@link #NO_DISTANCE} when an argument is out of range, or the
   *     sensor sees nothing within its range
   */
  public double GetInfraredData(int indexOfSensor, int numOfSensor) {
    if (numOfSensor < 1 || numOfSensor > sensors.size()) {
      return NO_DISTANCE;
    }
    if (indexOfSensor < 1 || indexOfSensor >= numOfSensor) {
      return NO_DISTANCE;
    }
    double range = sensors.get(indexOfSensor - 1).range();
    return Double.isFinite(range) ? range : NO_DISTANCE;
  }
}
