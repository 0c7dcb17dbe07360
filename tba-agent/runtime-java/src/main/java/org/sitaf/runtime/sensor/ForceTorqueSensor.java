package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;
import org.sitaf.runtime.geometry.Vector;

/** A force and torque sensor, in its own frame. */
public interface ForceTorqueSensor extends Device {
  /** Newtons. */
  Vector force();

  /** Newton metres. */
  Vector torque();
}
