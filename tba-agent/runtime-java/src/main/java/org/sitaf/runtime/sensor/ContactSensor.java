package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;

/** A contact sensor, such as a bumper. */
public interface ContactSensor extends Device {
  /** Whether it is pressed. */
  boolean isPressed();

  /** Contact force in newtons. */
  double force();
}
