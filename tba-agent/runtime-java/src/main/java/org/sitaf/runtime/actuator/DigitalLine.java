package org.sitaf.runtime.actuator;

/** A digital input or output. */
public interface DigitalLine {
  /** The device's name in the world description. */
  String name();

  /** Its level. */
  boolean isHigh();

  /** Sets its level. */
  void set(boolean high);
}
