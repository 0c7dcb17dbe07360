package org.sitaf.runtime.simulation;

import org.sitaf.runtime.sensor.JointEncoder;

/** The measurements that encoders and motors share. */
interface SimulatedJoint extends SimulatedDevice, JointEncoder {
  @Override
  default double position() {
    return access().read(reading -> reading.getJoint().getPosition());
  }

  @Override
  default double velocity() {
    return access().read(reading -> reading.getJoint().getVelocity());
  }
}
