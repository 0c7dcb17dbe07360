package org.sitaf.runtime.simulation;

import org.sitaf.runtime.Device;
import org.sitaf.runtime.simulation.SimulatedHardware.Access;

/** What all devices of a simulated robot have in common. */
interface SimulatedDevice extends Device {
  /** The way to its readings and to the simulator. */
  Access access();

  @Override
  default String name() {
    return access().name();
  }
}
