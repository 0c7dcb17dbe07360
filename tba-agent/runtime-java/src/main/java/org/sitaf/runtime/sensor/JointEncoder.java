package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;

/** An encoder of a joint. */
public interface JointEncoder extends Device {
  /** Radians, or metres for a prismatic joint. */
  double position();

  /** Radians or metres per second. */
  double velocity();
}
