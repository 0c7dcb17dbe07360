package org.sitaf.examples.approach;

import java.time.Duration;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.actuator.DifferentialDrive;
import org.sitaf.runtime.sensor.ContactSensor;
import org.sitaf.runtime.sensor.LaserScanner;

/** Drives straight towards a wall, slows down as it gets closer, and stops in front of it. */
public final class WallApproach {
  private static final double FASTEST = 0.4;
  private static final double GAIN = 1.5;
  private static final double CLOSE_ENOUGH = 0.01;
  private static final Duration PERIOD = Duration.ofMillis(20);
  private static final Duration LONGEST = Duration.ofSeconds(20);

  private final DifferentialDrive base;
  private final LaserScanner lidar;
  private final ContactSensor bumper;
  private final Hardware hardware;
  private double remaining;

  public WallApproach(Hardware hardware) {
    this.hardware = hardware;
    base = hardware.differentialDrive("base");
    lidar = hardware.laserScanner("lidar");
    bumper = hardware.contactSensor("bumper");
  }

  public boolean Approach(double distance) {
    Duration end = hardware.time().plus(LONGEST);
    while (hardware.time().compareTo(end) < 0 && !bumper.isPressed()) {
      double left = ahead() - distance;
      remaining = left;
      if (left < CLOSE_ENOUGH) {
        base.drive(0, 0);
        return true;
      }
      base.drive(Math.min(FASTEST, GAIN * left), 0);
      hardware.sleep(PERIOD);
    }
    base.drive(0, 0);
    return false;
  }

  /** The output data port: the distance that is left, in metres. */
  public double remaining() {
    return remaining;
  }

  /** The reading of the middle ray, in metres from the mast. */
  private double ahead() {
    double[] ranges = lidar.ranges();
    return ranges[ranges.length / 2];
  }
}
