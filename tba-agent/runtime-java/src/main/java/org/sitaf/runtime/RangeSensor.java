package org.sitaf.runtime;

/**
 * A sensor that measures the distance to the nearest surface along its ray; shape of {@code
 * sensor_msgs/Range}.
 */
public interface RangeSensor extends Device {
  /**
   * The distance at the current step in metres. As REP-117 has it: positive infinity when nothing
   * is within {@link #maxRange()}, negative infinity when something is nearer than {@link
   * #minRange()} or around the sensor, NaN when the reading failed.
   */
  double range();

  /** Smallest distance that the sensor measures, in metres, inclusive. */
  double minRange();

  /** Largest distance that the sensor measures, in metres, inclusive. */
  double maxRange();
}
