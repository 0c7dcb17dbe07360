package org.sitaf.runtime.actuator;

import org.sitaf.runtime.Device;

/** A base on two driven wheels. */
public interface DifferentialDrive extends Device {
  /** Measured speed in metres per second, forward. */
  double linear();

  /** Measured turning in radians per second, counterclockwise. */
  double angular();

  /** Radians that the left wheel has turned. */
  double leftPosition();

  /** Radians that the right wheel has turned. */
  double rightPosition();

  /**
   * Commands a speed in m/s and a turning in rad/s; {@link IllegalArgumentException} beyond its
   * limits.
   */
  void drive(double linear, double angular);
}
