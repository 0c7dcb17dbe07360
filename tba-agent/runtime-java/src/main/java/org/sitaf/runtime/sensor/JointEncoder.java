package org.sitaf.runtime.sensor;

/** What is measured at a joint. */
public interface JointEncoder {
  /** The device's name in the world description. */
  String name();

  /** Radians, or metres for a slide. */
  double position();

  /** Radians or metres per second. */
  double velocity();
}
