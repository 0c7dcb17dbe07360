package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;

/** A bumper. */
public interface ContactSensor extends Device {
  /** Whether anything presses on it. */
  boolean isPressed();

  /** How hard, in newtons. */
  double force();
}
