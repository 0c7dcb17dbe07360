package org.sitaf.runtime.actuator;

import org.sitaf.runtime.Device;

/** A gripper with two fingers. */
public interface Gripper extends Device {
  /** Measured distance between the fingers in metres. */
  double width();

  /** What the fingers exert, in newtons; closing is negative. */
  double effort();

  /** Goes to a width in metres; {@link IllegalArgumentException} beyond its limits. */
  void move(double width);
}
