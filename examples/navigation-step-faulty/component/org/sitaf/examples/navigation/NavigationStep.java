package org.sitaf.examples.navigation;

import org.sitaf.runtime.Out;
import sitaf.interfaces.Decision;
import sitaf.interfaces.NoEcho;
import sitaf.interfaces.RangeFinder;
import sitaf.interfaces.WheelController;

/** One navigation step: measures the distance ahead twice and drives by the shorter reading. */
public final class NavigationStep {
  private static final double SLOW_SPEED = 0.3;

  private final RangeFinder finder;
  private final WheelController wheels;
  private double safeDistance = 1.0;

  public NavigationStep(RangeFinder finder, WheelController wheels) {
    this.finder = finder;
    this.wheels = wheels;
  }

  /** In metres. At shorter distances the robot halts; at less than twice this distance it is slow. */
  public void setSafeDistance(double metres) {
    safeDistance = metres;
  }

  public Decision Step(double desiredSpeed, Out<Double> commanded) {
    double ahead = look();
    if (ahead >= safeDistance) {
      ahead = Math.min(ahead, look());
    }
    if (ahead < safeDistance) {
      wheels.Stop();
      commanded.set(0.0);
      return Decision.HALT;
    }
    boolean near = ahead < 2 * safeDistance;
    double speed = near ? Math.min(desiredSpeed, SLOW_SPEED) : desiredSpeed;
    wheels.Drive(desiredSpeed);
    commanded.set(speed);
    return near ? Decision.SLOW_DOWN : Decision.GO;
  }

  /** Without an echo the distance is unknown: returns 0, so that the robot halts. */
  private double look() {
    try {
      double range = finder.GetRange();
      return Double.isNaN(range) ? Double.POSITIVE_INFINITY : range;
    } catch (NoEcho e) {
      return 0;
    }
  }
}
