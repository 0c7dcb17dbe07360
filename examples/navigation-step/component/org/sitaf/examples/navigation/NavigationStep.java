package org.sitaf.examples.navigation;

import org.sitaf.runtime.Out;
import sitaf.interfaces.Decision;
import sitaf.interfaces.NoEcho;
import sitaf.interfaces.RangeFinder;
import sitaf.interfaces.WheelController;

/** One step of a navigation: looks ahead twice, believes the nearer reading, and drives by it. */
public final class NavigationStep {
  private static final double SLOW_SPEED = 0.3;

  private final RangeFinder finder;
  private final WheelController wheels;
  private double safeDistance = 1.0;

  public NavigationStep(RangeFinder finder, WheelController wheels) {
    this.finder = finder;
    this.wheels = wheels;
  }

  /** Below it the robot halts, below twice of it the robot is slow; metres. */
  public void setSafeDistance(double metres) {
    safeDistance = metres;
  }

  public Decision Step(double desiredSpeed, Out<Double> commanded) {
    double ahead = Math.min(look(), look());
    if (ahead < safeDistance) {
      wheels.Stop();
      commanded.set(0.0);
      return Decision.HALT;
    }
    boolean near = ahead < 2 * safeDistance;
    double speed = near ? Math.min(desiredSpeed, SLOW_SPEED) : desiredSpeed;
    wheels.Drive(speed);
    commanded.set(speed);
    return near ? Decision.SLOW_DOWN : Decision.GO;
  }

  /** A sensor without an echo says nothing, so that the robot must not trust the way. */
  private double look() {
    try {
      double range = finder.GetRange();
      return Double.isNaN(range) ? Double.POSITIVE_INFINITY : range;
    } catch (NoEcho e) {
      return 0;
    }
  }
}
