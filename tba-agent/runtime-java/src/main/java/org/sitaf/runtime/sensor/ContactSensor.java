package org.sitaf.runtime.sensor;

/** A bumper. */
public interface ContactSensor {
  /** The device's name in the world description. */
  String name();

  /** Whether anything presses on it. */
  boolean isPressed();

  /** How hard, in newtons. */
  double force();
}
