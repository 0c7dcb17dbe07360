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
 * The robot's hardware, as a component under test sees it. A component gets it by a constructor
 * argument of this type, or by {@link #current()}.
 *
 * <p>Only the test driver moves time: between two steps of the simulation every reading stays the
 * same, however often it is read, and reading costs no round trip to the simulator.
 */
public interface Hardware {

  /**
   * A sensor that measures one distance, such as an infrared or an ultrasonic sensor.
   *
   * @throws IllegalArgumentException when the robot has no range sensor of that name; the message
   *     lists those that it has
   */
  RangeSensor rangeSensor(String name);

  /**
   * A laser scanner.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  LaserScanner laserScanner(String name);

  /**
   * An inertial unit.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  ImuSensor imu(String name);

  /**
   * The encoder of a joint.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  JointEncoder jointEncoder(String name);

  /**
   * A sensor of position and orientation.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  PoseSensor poseSensor(String name);

  /**
   * A force and torque sensor.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  ForceTorqueSensor forceTorqueSensor(String name);

  /**
   * A bumper.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  ContactSensor contactSensor(String name);

  /**
   * A camera.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  Camera camera(String name);

  /**
   * A compass.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  Magnetometer magnetometer(String name);

  /**
   * A battery.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  Battery battery(String name);

  /**
   * The motor of a joint.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  JointMotor jointMotor(String name);

  /**
   * A base on two driven wheels.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  DifferentialDrive differentialDrive(String name);

  /**
   * A gripper.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  Gripper gripper(String name);

  /**
   * A digital input or output.
   *
   * @throws IllegalArgumentException when the robot has none of that name
   */
  DigitalLine digitalLine(String name);

  /** Simulation time since the case began. */
  Duration time();

  /**
   * Waits in simulation time, rounded up to whole steps; other readings are current afterwards.
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
