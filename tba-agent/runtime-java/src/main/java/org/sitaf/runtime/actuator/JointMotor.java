package org.sitaf.runtime.actuator;

import org.sitaf.runtime.sensor.JointEncoder;

/**
 * A motor of a joint. The world description defines which command it supports.
 *
 * <p>An unsupported command, or one beyond the limits, throws an {@link IllegalArgumentException}.
 */
public interface JointMotor extends JointEncoder {
  /** Measured effort in newton metres or newtons. */
  double effort();

  /** Commands a position in radians or metres. */
  void position(double target);

  /** Commands a velocity in radians or metres per second. */
  void velocity(double target);

  /** Commands an effort in newton metres or newtons. */
  void effort(double target);
}
