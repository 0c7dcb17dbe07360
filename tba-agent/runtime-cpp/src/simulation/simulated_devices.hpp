#pragma once

#include <string>
#include <vector>

#include "simulation/simulated_hardware.hpp"
#include "sitaf/hardware.hpp"
#include "sitaf/runtime/stopwatch.hpp"

namespace sitaf::simulation {

/// Access of one device to its readings and the simulator; measured as hardware time.
class Access {
 public:
  Access(const Device& device, const FrozenWorld& world, runtime::Stopwatch& stopwatch, Simulator& simulator)
      : device_(device), world_(world), stopwatch_(stopwatch), simulator_(simulator) {}

  const std::string& name() const { return device_.name; }

  /// A number of the reading at the current step.
  double number(std::size_t index) const {
    const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
    return world_.read(device_.first + index, [](const double* at) { return *at; });
  }

  Vector vector(std::size_t first) const {
    const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
    return world_.read(device_.first + first, [](const double* at) { return Vector{at[0], at[1], at[2]}; });
  }

  Quaternion rotation(std::size_t first) const {
    const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
    return world_.read(device_.first + first, [](const double* at) { return Quaternion{at[0], at[1], at[2], at[3]}; });
  }

  std::vector<double> all() const {
    const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
    return world_.read(device_.first, [this](const double* at) { return std::vector<double>(at, at + device_.count); });
  }

  /// The same access, after pending commands were sent: for numbers that commands change before time advances.
  const Access& afterCommands() const {
    const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
    simulator_.sendPending();
    return *this;
  }

  /// A constant number of the reading.
  double constant(std::size_t index) const { return device_.constants.at(index); }

  void write(sim::v1::DeviceCommand command) const {
    const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
    command.set_device(device_.name);
    simulator_.write(std::move(command));
  }

  Image look() const {
    const runtime::Stopwatch::ExcludedTime excluded(stopwatch_, runtime::Stopwatch::ExcludedTime::Kind::hardware);
    const sim::v1::Image seen = simulator_.look(device_.name);
    return {seen.width(), seen.height(), seen.encoding(), std::vector<std::uint8_t>(seen.data().begin(), seen.data().end())};
  }

 private:
  const Device& device_;
  const FrozenWorld& world_;
  runtime::Stopwatch& stopwatch_;
  Simulator& simulator_;
};

/// Base of all devices, which read the numbers of the current step.
template <class Interface>
class Simulated : public Interface {
 public:
  explicit Simulated(const Access& access) : access_(access) {}
  const std::string& name() const override { return access_.name(); }

 protected:
  const Access access_;
};

struct SimulatedRange final : Simulated<RangeSensor> {
  using Simulated::Simulated;
  double range() const override { return access_.number(0); }
  double minRange() const override { return access_.constant(0); }
  double maxRange() const override { return access_.constant(1); }
};

struct SimulatedScanner final : Simulated<LaserScanner> {
  using Simulated::Simulated;
  double angleMin() const override { return access_.constant(0); }
  double angleMax() const override { return access_.constant(1); }
  double angleIncrement() const override { return access_.constant(2); }
  double minRange() const override { return access_.constant(3); }
  double maxRange() const override { return access_.constant(4); }
  std::vector<double> ranges() const override { return access_.all(); }
};

struct SimulatedImu final : Simulated<ImuSensor> {
  using Simulated::Simulated;
  Quaternion orientation() const override { return access_.rotation(0); }
  Vector angularVelocity() const override { return access_.vector(4); }
  Vector linearAcceleration() const override { return access_.afterCommands().vector(7); }
};

struct SimulatedEncoder final : Simulated<JointEncoder> {
  using Simulated::Simulated;
  double position() const override { return access_.number(0); }
  double velocity() const override { return access_.number(1); }
};

struct SimulatedPose final : Simulated<PoseSensor> {
  using Simulated::Simulated;
  Vector position() const override { return access_.vector(0); }
  Quaternion orientation() const override { return access_.rotation(3); }
};

struct SimulatedForce final : Simulated<ForceTorqueSensor> {
  using Simulated::Simulated;
  Vector force() const override { return access_.afterCommands().vector(0); }
  Vector torque() const override { return access_.afterCommands().vector(3); }
};

struct SimulatedBumper final : Simulated<ContactSensor> {
  using Simulated::Simulated;
  bool isPressed() const override { return access_.afterCommands().number(0) != 0; }
  double force() const override { return access_.afterCommands().number(1); }
};

struct SimulatedCamera final : Simulated<Camera> {
  using Simulated::Simulated;
  Image image() const override { return access_.look(); }
};

struct SimulatedCompass final : Simulated<Magnetometer> {
  using Simulated::Simulated;
  Vector field() const override { return access_.vector(0); }
};

struct SimulatedBattery final : Simulated<Battery> {
  using Simulated::Simulated;
  double voltage() const override { return access_.number(0); }
  double current() const override { return access_.number(1); }
  double charge() const override { return access_.number(2); }
  double percentage() const override { return access_.number(3); }
};

struct SimulatedMotor final : Simulated<JointMotor> {
  using Simulated::Simulated;
  double position() const override { return access_.number(0); }
  double velocity() const override { return access_.number(1); }
  double effort() const override { return access_.afterCommands().number(2); }
  void setPosition(double target) override {
    sim::v1::DeviceCommand command;
    command.mutable_joint()->set_position(target);
    access_.write(std::move(command));
  }
  void setVelocity(double target) override {
    sim::v1::DeviceCommand command;
    command.mutable_joint()->set_velocity(target);
    access_.write(std::move(command));
  }
  void setEffort(double target) override {
    sim::v1::DeviceCommand command;
    command.mutable_joint()->set_effort(target);
    access_.write(std::move(command));
  }
};

struct SimulatedDrive final : Simulated<DifferentialDrive> {
  using Simulated::Simulated;
  double linear() const override { return access_.number(0); }
  double angular() const override { return access_.number(1); }
  double leftPosition() const override { return access_.number(2); }
  double rightPosition() const override { return access_.number(3); }
  void drive(double linear, double angular) override {
    sim::v1::DeviceCommand command;
    command.mutable_drive()->set_linear(linear);
    command.mutable_drive()->set_angular(angular);
    access_.write(std::move(command));
  }
};

struct SimulatedGripper final : Simulated<Gripper> {
  using Simulated::Simulated;
  double width() const override { return access_.number(0); }
  double effort() const override { return access_.afterCommands().number(1); }
  void move(double width) override {
    sim::v1::DeviceCommand command;
    command.mutable_gripper()->set_width_m(width);
    access_.write(std::move(command));
  }
};

struct SimulatedLine final : Simulated<DigitalLine> {
  using Simulated::Simulated;
  bool isHigh() const override { return access_.afterCommands().number(0) != 0; }
  void set(bool high) override {
    sim::v1::DeviceCommand command;
    command.set_level(high);
    access_.write(std::move(command));
  }
};

}  // namespace sitaf::simulation
