#include "simulation/simulated_hardware.hpp"

#include <algorithm>
#include <stdexcept>

#include "simulation/simulated_devices.hpp"

namespace sitaf::simulation {

template <class Simulated>
Simulated& SimulatedHardware::device(std::string_view name, const char* kind, const char* article) {
  const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto made = made_.find(name);
  const Device* device = layout_.device(name);
  if (device == nullptr) {
    std::string existing;
    for (const std::string& known : devices()) {
      existing += (existing.empty() ? "" : ", ") + known;
    }
    throw std::invalid_argument("the robot has no device '" + std::string(name) + "'; it has [" + existing + "]");
  }
  if (device->kind != kind) {
    throw std::invalid_argument("device '" + device->name + "' is of kind " + device->kind + ", not " + article);
  }
  if (made != made_.end()) {
    return *std::static_pointer_cast<Simulated>(made->second);
  }
  auto created = std::make_shared<Simulated>(Access(*device, world_, stopwatch_, simulator_));
  made_.emplace(device->name, created);
  return *created;
}

RangeSensor& SimulatedHardware::rangeSensor(std::string_view name) { return device<SimulatedRange>(name, "range", "a range sensor"); }

LaserScanner& SimulatedHardware::laserScanner(std::string_view name) {
  return device<SimulatedScanner>(name, "laser_scan", "a laser scanner");
}

ImuSensor& SimulatedHardware::imu(std::string_view name) { return device<SimulatedImu>(name, "imu", "an inertial unit"); }

JointEncoder& SimulatedHardware::jointEncoder(std::string_view name) {
  return device<SimulatedEncoder>(name, "joint_encoder", "a joint encoder");
}

PoseSensor& SimulatedHardware::poseSensor(std::string_view name) { return device<SimulatedPose>(name, "pose", "a pose sensor"); }

ForceTorqueSensor& SimulatedHardware::forceTorqueSensor(std::string_view name) {
  return device<SimulatedForce>(name, "force_torque", "a force and torque sensor");
}

ContactSensor& SimulatedHardware::contactSensor(std::string_view name) { return device<SimulatedBumper>(name, "contact", "a bumper"); }

Camera& SimulatedHardware::camera(std::string_view name) { return device<SimulatedCamera>(name, "camera", "a camera"); }

Magnetometer& SimulatedHardware::magnetometer(std::string_view name) {
  return device<SimulatedCompass>(name, "magnetometer", "a magnetometer");
}

Battery& SimulatedHardware::battery(std::string_view name) { return device<SimulatedBattery>(name, "battery", "a battery"); }

JointMotor& SimulatedHardware::jointMotor(std::string_view name) { return device<SimulatedMotor>(name, "joint_motor", "a joint motor"); }

DifferentialDrive& SimulatedHardware::differentialDrive(std::string_view name) {
  return device<SimulatedDrive>(name, "differential_drive", "a differential drive");
}

Gripper& SimulatedHardware::gripper(std::string_view name) { return device<SimulatedGripper>(name, "gripper", "a gripper"); }

DigitalLine& SimulatedHardware::digitalLine(std::string_view name) { return device<SimulatedLine>(name, "digital_io", "a digital line"); }

void SimulatedHardware::sleep(std::chrono::nanoseconds duration) {
  if (duration.count() < 0) {
    throw std::invalid_argument("cannot sleep for " + std::to_string(duration.count()) + " ns");
  }
  const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
  simulator_.sleep(duration);
}

std::vector<std::string> SimulatedHardware::devices() const {
  std::vector<std::string> names;
  for (const Device& device : layout_.devices()) {
    names.push_back(device.name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace sitaf::simulation
