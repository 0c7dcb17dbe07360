package org.sitaf.runtime.sensor;

import org.sitaf.runtime.geometry.Vector;

/** A compass, in its own frame. */
public interface Magnetometer {
  /** The device's name in the world description. */
  String name();

  /** Tesla. */
  Vector field();
}
