package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;
import org.sitaf.runtime.geometry.Vector;

/** A magnetometer, in its own frame. */
public interface Magnetometer extends Device {
  /** Magnetic field in tesla. */
  Vector field();
}
