#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "simulation/frozen_world.hpp"
#include "sitaf/hardware.hpp"
#include "sitaf/runtime/stopwatch.hpp"

namespace sitaf::simulation {

/// Operations that call the simulator.
class Simulator {
 public:
  virtual ~Simulator() = default;
  /// Commands a device, at the latest with the next step.
  virtual void write(sim::v1::DeviceCommand command) = 0;
  /// Sends the commands that wait for the next step.
  virtual void sendPending() = 0;
  virtual sim::v1::Image look(const std::string& camera) = 0;
  virtual void sleep(std::chrono::nanoseconds time) = 0;
};

/// The devices of a simulated robot. Readings come from the state after the last step, without a round trip; images and waits are calls to
/// the simulator. Commands travel with the next wait, or with a reading that they change before time advances.
class SimulatedHardware : public Hardware {
 public:
  /// All arguments must live as long as the hardware.
  SimulatedHardware(const Layout& layout, const FrozenWorld& world, runtime::Stopwatch& stopwatch, Simulator& simulator)
      : layout_(layout), world_(world), stopwatch_(stopwatch), simulator_(simulator) {}

  RangeSensor& rangeSensor(std::string_view name) override;
  LaserScanner& laserScanner(std::string_view name) override;
  ImuSensor& imu(std::string_view name) override;
  JointEncoder& jointEncoder(std::string_view name) override;
  PoseSensor& poseSensor(std::string_view name) override;
  ForceTorqueSensor& forceTorqueSensor(std::string_view name) override;
  ContactSensor& contactSensor(std::string_view name) override;
  Camera& camera(std::string_view name) override;
  Magnetometer& magnetometer(std::string_view name) override;
  Battery& battery(std::string_view name) override;
  JointMotor& jointMotor(std::string_view name) override;
  DifferentialDrive& differentialDrive(std::string_view name) override;
  Gripper& gripper(std::string_view name) override;
  DigitalLine& digitalLine(std::string_view name) override;
  std::chrono::nanoseconds time() const override { return world_.time(); }
  void sleep(std::chrono::nanoseconds duration) override;
  std::vector<std::string> devices() const override;

 private:
  template <class Simulated>
  Simulated& device(std::string_view name, const char* kind, const char* article);

  const Layout& layout_;
  const FrozenWorld& world_;
  runtime::Stopwatch& stopwatch_;
  Simulator& simulator_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<void>, std::less<>> made_;
};

}  // namespace sitaf::simulation
