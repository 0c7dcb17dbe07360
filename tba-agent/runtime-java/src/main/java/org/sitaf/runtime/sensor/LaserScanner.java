package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;

/** A laser scanner; shape of {@code sensor_msgs/LaserScan}. */
public interface LaserScanner extends Device {
  /** Angle of the first ray in radians, counterclockwise from straight ahead. */
  double angleMin();

  /** Angle of the last ray in radians. */
  double angleMax();

  /** Angle between two rays in radians. */
  double angleIncrement();

  /** Smallest distance that it measures, in metres. */
  double minRange();

  /** Largest distance that it measures, in metres. */
  double maxRange();

  /** Distances in metres, one for each ray, in a new array; infinities and NaN as in REP-117. */
  double[] ranges();
}
