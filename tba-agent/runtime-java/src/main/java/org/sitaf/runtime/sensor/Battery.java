package org.sitaf.runtime.sensor;

import org.sitaf.runtime.Device;

/** A battery; shape of {@code sensor_msgs/BatteryState}. */
public interface Battery extends Device {
  /** Volts. */
  double voltage();

  /** Amperes, negative while it discharges. */
  double current();

  /** Ampere hours. */
  double charge();

  /** 0 to 1. */
  double percentage();
}
