package org.sitaf.runtime.simulation;

import org.sitaf.runtime.Device;
import org.sitaf.runtime.simulation.SimulatedHardware.Access;

/** Base of all devices of a simulated robot. */
interface SimulatedDevice extends Device {
  /** Access to its readings and to the simulator. */
  Access access();

  @Override
  default String name() {
    return access().name();
  }
}
