package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;
import org.sitaf.runtime.geometry.Quaternion;
import org.sitaf.runtime.geometry.Vector;

/** A sensor of position and orientation in the world. */
public interface PoseSensor extends Device {
  /** Metres. */
  Vector position();

  /** Its orientation in the world. */
  Quaternion orientation();
}
