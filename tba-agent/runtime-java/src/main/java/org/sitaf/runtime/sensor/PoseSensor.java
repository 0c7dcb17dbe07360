package org.sitaf.runtime.sensor;

import org.sitaf.runtime.geometry.Quaternion;
import org.sitaf.runtime.geometry.Vector;

/** A sensor of position and orientation in the world. */
public interface PoseSensor {
  /** The device's name in the world description. */
  String name();

  /** Metres. */
  Vector position();

  /** Its orientation in the world. */
  Quaternion orientation();
}
