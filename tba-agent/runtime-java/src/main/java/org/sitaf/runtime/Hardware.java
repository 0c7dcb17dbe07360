package org.sitaf.runtime;

import java.time.Duration;
import java.util.Set;
import org.sitaf.runtime.actuator.DifferentialDrive;
import org.sitaf.runtime.actuator.DigitalLine;
import org.sitaf.runtime.actuator.Gripper;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.runtime.sensor.Battery;
import org.sitaf.runtime.sensor.Camera;
import org.sitaf.runtime.sensor.ContactSensor;
import org.sitaf.runtime.sensor.ForceTorqueSensor;
import org.sitaf.runtime.sensor.ImuSensor;
import org.sitaf.runtime.sensor.JointEncoder;
import org.sitaf.runtime.sensor.LaserScanner;
import org.sitaf.runtime.sensor.Magnetometer;
import org.sitaf.runtime.sensor.PoseSensor;

/**
 * The robot's hardware as a component under test sees it. A component gets it as a constructor
 * argument of this type, or from {@link #current()}.
 *
 * <p>Only the test driver advances time. Between two steps of the simulation all readings stay the
 * same, and reading needs no round trip to the simulator.
 */
public interface Hardware {

  /**
   * A sensor that measures one distance, such as an infrared or an ultrasonic sensor.
   *
   * @throws IllegalArgumentException when the robot has no range sensor with that name; the message
   *     lists the existing ones
   */
  RangeSensor rangeSensor(String name);

  /**
   * A laser scanner.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  LaserScanner laserScanner(String name);

  /**
   * An inertial unit.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  ImuSensor imu(String name);

  /**
   * The encoder of a joint.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  JointEncoder jointEncoder(String name);

  /**
   * A sensor of position and orientation.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  PoseSensor poseSensor(String name);

  /**
   * A force and torque sensor.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  ForceTorqueSensor forceTorqueSensor(String name);

  /**
   * A bumper.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  ContactSensor contactSensor(String name);

  /**
   * A camera.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  Camera camera(String name);

  /**
   * A compass.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  Magnetometer magnetometer(String name);

  /**
   * A battery.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  Battery battery(String name);

  /**
   * The motor of a joint.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  JointMotor jointMotor(String name);

  /**
   * A base on two driven wheels.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  DifferentialDrive differentialDrive(String name);

  /**
   * A gripper.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  Gripper gripper(String name);

  /**
   * A digital input or output.
   *
   * @throws IllegalArgumentException when the robot has no such device
   */
  DigitalLine digitalLine(String name);

  /** Simulation time since the case began. */
  Duration time();

  /**
   * Waits in simulation time, rounded up to whole steps; then devices have new readings.
   *
   * @throws IllegalArgumentException for a negative duration
   */
  void sleep(Duration duration);

  /** Names of all devices of the robot. */
  Set<String> devices();

  /**
   * The hardware of the running test, for components whose constructor cannot take it.
   *
   * @throws IllegalStateException when no test with a simulated world is running
   */
  static Hardware current() {
    return CurrentHardware.get();
  }
}
