package robot;

import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.RangeSensor;
import sitaf.interfaces.Battery;
import sitaf.interfaces.NoContact;
import sitaf.interfaces.NotArmed;
import sitaf.interfaces.NotStopped;

/** The guard of examples/collision-guard in Java. */
public final class CollisionGuard {
  private static final double STOP_M = 0.5;
  private static final double LOW = 0.2;

  private final RangeSensor front;
  private final Battery battery;
  private boolean armed;
  private boolean stopped;

  public CollisionGuard(Hardware hardware, Battery battery) {
    this.front = hardware.rangeSensor("front");
    this.battery = battery;
  }

  public void Arm() {
    armed = true;
  }

  public void Disarm() {
    armed = false;
  }

  public String Check() {
    if (!armed) {
      throw new NotArmed("arm the guard first");
    }
    stopped |= front.range() < STOP_M;
    if (stopped) {
      return "STOP";
    }
    return isLow() ? "LOW" : "CLEAR";
  }

  public void Reset() {
    if (!stopped) {
      throw new NotStopped("nothing has stopped the car");
    }
    stopped = false;
  }

  private boolean isLow() {
    try {
      return battery.Level() < LOW;
    } catch (NoContact e) {
      return true;
    }
  }
}
