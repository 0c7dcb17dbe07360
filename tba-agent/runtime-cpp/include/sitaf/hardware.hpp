#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "sitaf/actuator/differential_drive.hpp"
#include "sitaf/actuator/digital_line.hpp"
#include "sitaf/actuator/gripper.hpp"
#include "sitaf/actuator/joint_motor.hpp"
#include "sitaf/sensor/battery.hpp"
#include "sitaf/sensor/camera.hpp"
#include "sitaf/sensor/contact_sensor.hpp"
#include "sitaf/sensor/force_torque_sensor.hpp"
#include "sitaf/sensor/imu_sensor.hpp"
#include "sitaf/sensor/joint_encoder.hpp"
#include "sitaf/sensor/laser_scanner.hpp"
#include "sitaf/sensor/magnetometer.hpp"
#include "sitaf/sensor/pose_sensor.hpp"
#include "sitaf/sensor/range_sensor.hpp"

namespace sitaf {

/// The robot's hardware as a component under test sees it. A component gets it as a constructor argument of this type, or from
/// current().
///
/// Only the test driver advances time. Between two steps of the simulation all readings stay the same, and reading needs no round
/// trip to the simulator. Devices live as long as the hardware. A name that the robot does not have, or of a device of another
/// kind, throws std::invalid_argument with a message that lists the existing devices.
class Hardware {
 public:
  virtual ~Hardware() = default;

  /// A sensor that measures one distance, such as an infrared or an ultrasonic sensor.
  virtual RangeSensor& rangeSensor(std::string_view name) = 0;

  /// A laser scanner.
  virtual LaserScanner& laserScanner(std::string_view name) = 0;

  /// An inertial measurement unit.
  virtual ImuSensor& imu(std::string_view name) = 0;

  /// The encoder of a joint.
  virtual JointEncoder& jointEncoder(std::string_view name) = 0;

  /// A sensor of position and orientation.
  virtual PoseSensor& poseSensor(std::string_view name) = 0;

  /// A force and torque sensor.
  virtual ForceTorqueSensor& forceTorqueSensor(std::string_view name) = 0;

  /// A contact sensor, such as a bumper.
  virtual ContactSensor& contactSensor(std::string_view name) = 0;

  /// A camera.
  virtual Camera& camera(std::string_view name) = 0;

  /// A magnetometer.
  virtual Magnetometer& magnetometer(std::string_view name) = 0;

  /// A battery.
  virtual Battery& battery(std::string_view name) = 0;

  /// The motor of a joint.
  virtual JointMotor& jointMotor(std::string_view name) = 0;

  /// A base on two driven wheels.
  virtual DifferentialDrive& differentialDrive(std::string_view name) = 0;

  /// A gripper.
  virtual Gripper& gripper(std::string_view name) = 0;

  /// A digital input or output.
  virtual DigitalLine& digitalLine(std::string_view name) = 0;

  /// Simulation time since the case began.
  virtual std::chrono::nanoseconds time() const = 0;

  /// Waits in simulation time, rounded up to whole steps; then devices have new readings. A negative duration throws
  /// std::invalid_argument.
  virtual void sleep(std::chrono::nanoseconds duration) = 0;

  /// Names of all devices of the robot, in alphabetical order.
  virtual std::vector<std::string> devices() const = 0;

  /// The hardware of the running test, for components whose constructor cannot take it; std::logic_error when no test with a
  /// simulated world is running.
  static Hardware& current();
};

}  // namespace sitaf
