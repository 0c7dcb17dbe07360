package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;
import org.sitaf.runtime.geometry.Quaternion;
import org.sitaf.runtime.geometry.Vector;

/** An inertial measurement unit; shape of {@code sensor_msgs/Imu}, in its own frame. */
public interface ImuSensor extends Device {
  /** Its orientation in the world. */
  Quaternion orientation();

  /** Radians per second. */
  Vector angularVelocity();

  /** Metres per second squared, including gravity: at rest it points upwards. */
  Vector linearAcceleration();
}
