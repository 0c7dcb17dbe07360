package org.sitaf.runtime.sensor;

import org.sitaf.runtime.geometry.Vector;

/** A force and torque sensor, in its own frame. */
public interface ForceTorqueSensor {
  /** The device's name in the world description. */
  String name();

  /** Newtons. */
  Vector force();

  /** Newton metres. */
  Vector torque();
}
