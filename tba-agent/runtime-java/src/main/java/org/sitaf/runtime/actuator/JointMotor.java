package org.sitaf.runtime.actuator;

import org.sitaf.runtime.sensor.JointEncoder;

/**
 * A motor at a joint. The world decides which of the commands it takes.
 *
 * <p>A command that it does not take, or beyond its limits, is an {@link IllegalArgumentException}.
 */
public interface JointMotor extends JointEncoder {
  /** What it exerts, in newton metres or newtons. */
  double effort();

  /** Goes to a position in radians or metres. */
  void position(double target);

  /** Keeps a velocity in radians or metres per second. */
  void velocity(double target);

  /** Exerts an effort in newton metres or newtons. */
  void effort(double target);
}
