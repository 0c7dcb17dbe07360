package org.sitaf.runtime.actuator;

import org.sitaf.runtime.Device;

/** A digital input or output. */
public interface DigitalLine extends Device {
  /** Its level. */
  boolean isHigh();

  /** Sets its level. */
  void set(boolean high);
}
