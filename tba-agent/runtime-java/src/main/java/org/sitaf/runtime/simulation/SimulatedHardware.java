package org.sitaf.runtime.simulation;

import java.time.Duration;
import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.RangeSensor;
import org.sitaf.runtime.Stopwatch;
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
import org.sitaf.runtime.simulation.frozen.FrozenWorld;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.Reading;

/**
 * The devices of a simulated robot. Readings come from the state after the last step, without a
 * round trip; images and waits are calls to the simulator. Commands travel with the next wait, or
 * with a reading that they change before time advances.
 */
final class SimulatedHardware implements Hardware {

  /** Operations that call the simulator. */
  interface Simulator {
    /** Commands a device, at the latest with the next step. */
    void write(DeviceCommand command);

    /** Sends the commands that wait for the next step. */
    void sendPending();

    Reading look(String camera);

    void advance(Duration time);
  }

  private final Map<String, String> kinds;
  private final Stopwatch stopwatch;
  private final Simulator simulator;
  private volatile FrozenWorld world;

  /**
   * Creates the devices of a world.
   *
   * @param kinds kind of each device, by name
   */
  SimulatedHardware(
      Map<String, String> kinds, Stopwatch stopwatch, FrozenWorld world, Simulator simulator) {
    this.kinds = Collections.unmodifiableMap(new TreeMap<>(kinds));
    this.stopwatch = stopwatch;
    this.world = world;
    this.simulator = simulator;
  }

  void freeze(FrozenWorld newWorld) {
    world = newWorld;
  }

  @Override
  public Set<String> devices() {
    return kinds.keySet();
  }

  @Override
  public RangeSensor rangeSensor(String name) {
    return device(name, "range", "a range sensor", SimulatedSensors.Range::new);
  }

  @Override
  public LaserScanner laserScanner(String name) {
    return device(name, "laser_scan", "a laser scanner", SimulatedSensors.Scanner::new);
  }

  @Override
  public ImuSensor imu(String name) {
    return device(name, "imu", "an inertial unit", SimulatedSensors.Imu::new);
  }

  @Override
  public JointEncoder jointEncoder(String name) {
    return device(name, "joint_encoder", "a joint encoder", SimulatedSensors.Encoder::new);
  }

  @Override
  public PoseSensor poseSensor(String name) {
    return device(name, "pose", "a pose sensor", SimulatedSensors.Pose::new);
  }

  @Override
  public ForceTorqueSensor forceTorqueSensor(String name) {
    return device(name, "force_torque", "a force and torque sensor", SimulatedSensors.Force::new);
  }

  @Override
  public ContactSensor contactSensor(String name) {
    return device(name, "contact", "a bumper", SimulatedSensors.Bumper::new);
  }

  @Override
  public Camera camera(String name) {
    return device(name, "camera", "a camera", SimulatedSensors.Eye::new);
  }

  @Override
  public Magnetometer magnetometer(String name) {
    return device(name, "magnetometer", "a magnetometer", SimulatedSensors.Compass::new);
  }

  @Override
  public Battery battery(String name) {
    return device(name, "battery", "a battery", SimulatedSensors.Accumulator::new);
  }

  @Override
  public JointMotor jointMotor(String name) {
    return device(name, "joint_motor", "a joint motor", SimulatedActuators.Motor::new);
  }

  @Override
  public DifferentialDrive differentialDrive(String name) {
    return device(
        name, "differential_drive", "a differential drive", SimulatedActuators.Drive::new);
  }

  @Override
  public Gripper gripper(String name) {
    return device(name, "gripper", "a gripper", SimulatedActuators.Hand::new);
  }

  @Override
  public DigitalLine digitalLine(String name) {
    return device(name, "digital_io", "a digital line", SimulatedActuators.Line::new);
  }

  @Override
  public Duration time() {
    return Duration.ofNanos(world.timeNanos());
  }

  @Override
  public void sleep(Duration duration) {
    if (duration.isNegative()) {
      throw new IllegalArgumentException("cannot sleep for " + duration);
    }
    long entered = stopwatch.enter();
    try {
      simulator.advance(duration);
    } finally {
      stopwatch.leaveHardware(entered);
    }
  }

  private <D> D device(String name, String kind, String article, Function<Access, D> device) {
    long entered = stopwatch.enter();
    try {
      String actual = kinds.get(name);
      if (actual == null) {
        throw new IllegalArgumentException(
            "the robot has no device '" + name + "'; it has " + kinds.keySet());
      }
      if (!actual.equals(kind)) {
        throw new IllegalArgumentException(
            "device '" + name + "' is of kind " + actual + ", not " + article);
      }
      return device.apply(new Access(name));
    } finally {
      stopwatch.leaveHardware(entered);
    }
  }

  /** Access of one device to its readings and the simulator; measured as hardware time. */
  final class Access {
    private final String name;

    private Access(String name) {
      this.name = name;
    }

    String name() {
      return name;
    }

    <V> V read(Function<Reading, V> part) {
      long entered = stopwatch.enter();
      try {
        return part.apply(world.reading(name));
      } finally {
        stopwatch.leaveHardware(entered);
      }
    }

    /** Reads a number that commands change before time advances. */
    <V> V readAfterCommands(Function<Reading, V> part) {
      long entered = stopwatch.enter();
      try {
        simulator.sendPending();
        return part.apply(world.reading(name));
      } finally {
        stopwatch.leaveHardware(entered);
      }
    }

    void write(DeviceCommand.Builder command) {
      long entered = stopwatch.enter();
      try {
        simulator.write(command.setDevice(name).build());
      } finally {
        stopwatch.leaveHardware(entered);
      }
    }

    Reading look() {
      long entered = stopwatch.enter();
      try {
        return simulator.look(name);
      } finally {
        stopwatch.leaveHardware(entered);
      }
    }
  }
}
