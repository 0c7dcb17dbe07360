package org.sitaf.runtime;

/** A sensor or an actuator of the robot. */
public interface Device {
  /** Its name in the world description. */
  String name();
}
