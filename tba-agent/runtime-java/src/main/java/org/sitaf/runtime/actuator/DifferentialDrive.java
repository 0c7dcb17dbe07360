package org.sitaf.runtime.actuator;

import org.sitaf.runtime.Device;

/** A mobile base with two driven wheels. */
public interface DifferentialDrive extends Device {
  /** Measured linear speed in metres per second, forward. */
  double linear();

  /** Measured angular speed in radians per second, counterclockwise. */
  double angular();

  /** Rotation of the left wheel in radians. */
  double leftPosition();

  /** Rotation of the right wheel in radians. */
  double rightPosition();

  /**
   * Commands a linear speed in m/s and an angular speed in rad/s; {@link IllegalArgumentException}
   * beyond the limits of the drive.
   */
  void drive(double linear, double angular);
}
