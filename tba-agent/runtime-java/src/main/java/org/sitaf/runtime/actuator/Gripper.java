package org.sitaf.runtime.actuator;

import org.sitaf.runtime.Device;

/** A gripper with two fingers. */
public interface Gripper extends Device {
  /** Measured distance between the fingers in metres. */
  double width();

  /** Force of the fingers in newtons; closing is negative. */
  double effort();

  /** Moves to a width in metres; {@link IllegalArgumentException} beyond the limits. */
  void move(double width);
}
