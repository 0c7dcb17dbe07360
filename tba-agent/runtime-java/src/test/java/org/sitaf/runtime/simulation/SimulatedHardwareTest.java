package org.sitaf.runtime.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.protobuf.ByteString;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.runtime.geometry.Quaternion;
import org.sitaf.runtime.geometry.Vector;
import org.sitaf.runtime.sensor.Camera;
import org.sitaf.runtime.sensor.ImuSensor;
import org.sitaf.runtime.sensor.LaserScanner;
import org.sitaf.runtime.simulation.frozen.FrozenWorld;
import org.sitaf.sim.v1.Contact;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.DriveCommand;
import org.sitaf.sim.v1.GripperCommand;
import org.sitaf.sim.v1.Image;
import org.sitaf.sim.v1.Imu;
import org.sitaf.sim.v1.JointCommand;
import org.sitaf.sim.v1.JointState;
import org.sitaf.sim.v1.LaserScan;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.Vector3;
import org.sitaf.sim.v1.WorldState;

/** Readings and commands of each kind of device. */
class SimulatedHardwareTest {
  private static final Map<String, String> KINDS =
      Map.of(
          "imu", "imu",
          "lidar", "laser_scan",
          "motor", "joint_motor",
          "bumper", "contact",
          "base", "differential_drive",
          "hand", "gripper",
          "lamp", "digital_io",
          "eye", "camera");

  private final List<DeviceCommand> commands = new ArrayList<>();
  private final List<Integer> sent = new ArrayList<>();
  private final List<Duration> advances = new ArrayList<>();
  private final SimulatedHardware hardware =
      new SimulatedHardware(KINDS, new Stopwatch(), FrozenWorld.of(state()), new Recorder());

  private final class Recorder implements SimulatedHardware.Simulator {
    @Override
    public void write(DeviceCommand command) {
      commands.add(command);
    }

    @Override
    public void sendPending() {
      sent.add(commands.size());
    }

    @Override
    public Reading look(String camera) {
      return Reading.newBuilder()
          .setDevice(camera)
          .setImage(
              Image.newBuilder()
                  .setWidth(2)
                  .setHeight(1)
                  .setEncoding("rgb8")
                  .setData(ByteString.copyFrom(new byte[] {1, 2, 3, 4, 5, 6})))
          .build();
    }

    @Override
    public void advance(Duration time) {
      advances.add(time);
    }
  }

  private static WorldState state() {
    return WorldState.newBuilder()
        .setTimeNs(2_500_000)
        .addReadings(
            Reading.newBuilder()
                .setDevice("imu")
                .setImu(
                    Imu.newBuilder()
                        .setOrientation(org.sitaf.sim.v1.Quaternion.newBuilder().setW(1))
                        .setLinearAcceleration(Vector3.newBuilder().setX(1).setY(2).setZ(9.81))))
        .addReadings(
            Reading.newBuilder()
                .setDevice("lidar")
                .setLaserScan(
                    LaserScan.newBuilder()
                        .setAngleMin(-1)
                        .setAngleMax(1)
                        .setRangeMaxM(6)
                        .addRangesM(0.5)
                        .addRangesM(Double.POSITIVE_INFINITY)))
        .addReadings(
            Reading.newBuilder()
                .setDevice("motor")
                .setJoint(JointState.newBuilder().setPosition(1).setVelocity(2).setEffort(3)))
        .addReadings(
            Reading.newBuilder()
                .setDevice("bumper")
                .setContact(Contact.newBuilder().setPressed(true).setForceN(4.5)))
        .build();
  }

  @Test
  void sensorsReadTheStateOfTheCurrentStep() {
    ImuSensor imu = hardware.imu("imu");
    assertThat(imu.linearAcceleration()).isEqualTo(new Vector(1, 2, 9.81));
    assertThat(imu.orientation()).isEqualTo(new Quaternion(0, 0, 0, 1));
    LaserScanner lidar = hardware.laserScanner("lidar");
    assertThat(lidar.ranges()).containsExactly(0.5, Double.POSITIVE_INFINITY);
    assertThat(lidar.maxRange()).isEqualTo(6);
    assertThat(hardware.contactSensor("bumper").isPressed()).isTrue();
    assertThat(hardware.time()).isEqualTo(Duration.ofNanos(2_500_000));
  }

  @Test
  void returnsANewArrayForEachScan() {
    LaserScanner lidar = hardware.laserScanner("lidar");
    lidar.ranges()[0] = 99;
    assertThat(lidar.ranges()[0]).isEqualTo(0.5);
  }

  @Test
  void actuatorsSendTheirCommands() {
    JointMotor motor = hardware.jointMotor("motor");
    motor.velocity(1.5);
    hardware.differentialDrive("base").drive(0.3, -1);
    hardware.gripper("hand").move(0.04);
    hardware.digitalLine("lamp").set(true);
    assertThat(commands)
        .containsExactly(
            command("motor").setJoint(JointCommand.newBuilder().setVelocity(1.5)).build(),
            command("base")
                .setDrive(DriveCommand.newBuilder().setLinear(0.3).setAngular(-1))
                .build(),
            command("hand").setGripper(GripperCommand.newBuilder().setWidthM(0.04)).build(),
            command("lamp").setLevel(true).build());
    assertThat(motor.position()).isEqualTo(1);
    assertThat(sent).isEmpty();
    assertThat(motor.effort()).isEqualTo(3);
    assertThat(sent).containsExactly(4);
  }

  @Test
  void imagesAreReadOnly() {
    Camera.Image image = hardware.camera("eye").image();
    assertThat(image.width()).isEqualTo(2);
    assertThat(image.data().get(5)).isEqualTo((byte) 6);
    assertThat(image.data().isReadOnly()).isTrue();
    assertThat(image.data().position()).isZero();
  }

  @Test
  void sleepAdvancesSimulationTime() {
    hardware.sleep(Duration.ofMillis(20));
    assertThat(advances).containsExactly(Duration.ofMillis(20));
    assertThatThrownBy(() -> hardware.sleep(Duration.ofMillis(-1)))
        .isInstanceOf(IllegalArgumentException.class);
    assertThat(advances).hasSize(1);
  }

  @Test
  void rejectsADeviceOfAnotherKind() {
    assertThatThrownBy(() -> hardware.gripper("motor"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("device 'motor' is of kind joint_motor, not a gripper");
  }

  private static DeviceCommand.Builder command(String device) {
    return DeviceCommand.newBuilder().setDevice(device);
  }
}
