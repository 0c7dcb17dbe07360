package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;
import org.sitaf.runtime.geometry.Vector;

/** A compass, in its own frame. */
public interface Magnetometer extends Device {
  /** Tesla. */
  Vector field();
}
