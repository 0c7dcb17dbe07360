package robot;

import java.time.Duration;
import java.util.Arrays;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.runtime.sensor.JointEncoder;
import sitaf.interfaces.ArmState;
import sitaf.interfaces.Clock;

public final class Arm {
  private final Hardware hardware;
  private final JointMotor motor;
  private final JointEncoder encoder;
  private final Clock clock;
  private double strongest = 1;
  private double most;
  private int starts;
  private int swings;
  private boolean initialised;
  private double[] angles = {};

  public Arm(Hardware hardware, Clock clock) {
    this.hardware = hardware;
    this.clock = clock;
    motor = hardware.jointMotor("motor");
    encoder = hardware.jointEncoder("encoder");
  }

  public void setStrongest(double effort) {
    strongest = effort;
  }

  public void onInitialize() {
    initialised = true;
  }

  public double Swing(double effort) {
    Duration begun = hardware.time();
    double now = clock.Now(swings);
    swings++;
    motor.effort(Math.min(effort, most));
    for (int i = 0; effort == 0 || i < 10; i++) {
      hardware.sleep(Duration.ofMillis(50));
      angles = Arrays.copyOf(angles, angles.length + 1);
      angles[angles.length - 1] = encoder.position();
    }
    motor.effort(0);
    return hardware.time().minus(begun).toNanos() / 1e9 + now;
  }

  public void Watch(double effort) {
    Swing(effort);
  }

  public void Limit(double bound) {
    if (!initialised) {
      throw new IllegalStateException("not initialised");
    }
    if (bound < 0 || bound > strongest) {
      throw new TooStrong();
    }
    most = bound;
  }

  public int start() {
    return ++starts;
  }

  public ArmState state() {
    return new ArmState(encoder.position(), swings);
  }

  public double getMost() {
    return most;
  }

  public double[] angles() {
    return angles;
  }

  public static final class TooStrong extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }
}
