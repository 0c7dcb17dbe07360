package org.sitaf.examples.joint;

import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.runtime.sensor.JointEncoder;

/** A PID controller whose damping is scheduled over the target. It is executed once per period. */
public final class JointController {
  private static final double PERIOD = 0.01;
  private static final double STRONGEST = 8;

  private final JointMotor motor;
  private final JointEncoder encoder;
  private double kp;
  private double ki;
  private double kd;
  private double target;
  private double sum;
  private long periods;

  public JointController(Hardware hardware) {
    motor = hardware.jointMotor("motor");
    encoder = hardware.jointEncoder("encoder");
  }

  public void setKp(double gain) {
    kp = gain;
  }

  public void setKi(double gain) {
    ki = gain;
  }

  public void setKd(double gain) {
    kd = gain;
  }

  /** Holds the initial angle until a target is set. */
  public void start() {
    target = encoder.position();
  }

  public void SetTarget(double angle) {
    target = angle;
  }

  public double GetTime() {
    return periods * PERIOD;
  }

  public void onExecute() {
    periods++;
    double error = target - encoder.position();
    double effort = kp * error + ki * (sum + error * PERIOD) - damping() * encoder.velocity();
    boolean saturated = Math.abs(effort) > STRONGEST;
    if (!saturated) {
      sum += error * PERIOD;
    }
    motor.effort(Math.max(-STRONGEST, Math.min(STRONGEST, effort)));
  }

  /** A link that points upwards needs less damping. */
  private double damping() {
    double entry = (target - 0.55) / 0.3;
    return kd * (1 - 0.2 * Math.max(0, target) - 0.8 * Math.exp(-entry * entry));
  }
}
