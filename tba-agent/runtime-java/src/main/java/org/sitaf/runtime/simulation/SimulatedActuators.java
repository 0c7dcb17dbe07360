package org.sitaf.runtime.simulation;

import org.sitaf.runtime.actuator.DifferentialDrive;
import org.sitaf.runtime.actuator.DigitalLine;
import org.sitaf.runtime.actuator.Gripper;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.runtime.simulation.SimulatedHardware.Access;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.DriveCommand;
import org.sitaf.sim.v1.GripperCommand;
import org.sitaf.sim.v1.JointCommand;

/** The actuators of a simulated robot. */
final class SimulatedActuators {
  private SimulatedActuators() {}

  record Motor(Access access) implements SimulatedJoint, JointMotor {

    @Override
    public double effort() {
      return access.readAfterCommands(reading -> reading.getJoint().getEffort());
    }

    @Override
    public void position(double target) {
      access.write(
          DeviceCommand.newBuilder().setJoint(JointCommand.newBuilder().setPosition(target)));
    }

    @Override
    public void velocity(double target) {
      access.write(
          DeviceCommand.newBuilder().setJoint(JointCommand.newBuilder().setVelocity(target)));
    }

    @Override
    public void effort(double target) {
      access.write(
          DeviceCommand.newBuilder().setJoint(JointCommand.newBuilder().setEffort(target)));
    }
  }

  record Drive(Access access) implements SimulatedDevice, DifferentialDrive {
    @Override
    public double linear() {
      return access.read(reading -> reading.getDrive().getLinear());
    }

    @Override
    public double angular() {
      return access.read(reading -> reading.getDrive().getAngular());
    }

    @Override
    public double leftPosition() {
      return access.read(reading -> reading.getDrive().getLeftPosition());
    }

    @Override
    public double rightPosition() {
      return access.read(reading -> reading.getDrive().getRightPosition());
    }

    @Override
    public void drive(double linear, double angular) {
      access.write(
          DeviceCommand.newBuilder()
              .setDrive(DriveCommand.newBuilder().setLinear(linear).setAngular(angular)));
    }
  }

  record Hand(Access access) implements SimulatedDevice, Gripper {
    @Override
    public double width() {
      return access.read(reading -> reading.getGripper().getWidthM());
    }

    @Override
    public double effort() {
      return access.readAfterCommands(reading -> reading.getGripper().getEffortN());
    }

    @Override
    public void move(double width) {
      access.write(
          DeviceCommand.newBuilder().setGripper(GripperCommand.newBuilder().setWidthM(width)));
    }
  }

  record Line(Access access) implements SimulatedDevice, DigitalLine {
    @Override
    public boolean isHigh() {
      return access.readAfterCommands(reading -> reading.getLevel());
    }

    @Override
    public void set(boolean high) {
      access.write(DeviceCommand.newBuilder().setLevel(high));
    }
  }
}
