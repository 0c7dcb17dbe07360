package org.sitaf.runtime.sensor;

/** A battery; shape of {@code sensor_msgs/BatteryState}. */
public interface Battery {
  /** The device's name in the world description. */
  String name();

  /** Volts. */
  double voltage();

  /** Amperes, negative while it discharges. */
  double current();

  /** Ampere hours. */
  double charge();

  /** 0 to 1. */
  double percentage();
}
