package org.sitaf.runtime;

/**
 * A sensor that measures the distance to the nearest surface along its ray; shape of {@code
 * sensor_msgs/Range}.
 */
public interface RangeSensor extends Device {
  /**
   * The distance at the current step in metres. As in REP-117: positive infinity when nothing is
   * within {@link #maxRange()}, negative infinity when an object is nearer than {@link #minRange()}
   * or the sensor is inside an object, NaN when the reading is invalid.
   */
  double range();

  /** Smallest distance that the sensor measures, in metres, inclusive. */
  double minRange();

  /** Largest distance that the sensor measures, in metres, inclusive. */
  double maxRange();
}
