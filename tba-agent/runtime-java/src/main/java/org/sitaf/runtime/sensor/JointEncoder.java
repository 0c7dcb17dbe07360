package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;

/** What is measured at a joint. */
public interface JointEncoder extends Device {
  /** Radians, or metres for a slide. */
  double position();

  /** Radians or metres per second. */
  double velocity();
}
