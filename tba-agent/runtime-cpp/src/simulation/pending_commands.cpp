#include "simulation/pending_commands.hpp"

#include <algorithm>
#include <cmath>

namespace sitaf::simulation {
namespace {

namespace wire = sim::v1;

/// Commands without a step between them are sent when there are so many.
constexpr std::size_t maxCommands = 1024;

}  // namespace

PendingCommands::PendingCommands(const wire::WorldDescription& world) {
  for (const wire::DeviceDescription& device : world.devices()) {
    for (const wire::CommandNumber& number : device.commands()) {
      limits_[device.name()][number.name()] = {number.min(), number.max()};
    }
    bounds_[device.name()].assign(device.bounds().begin(), device.bounds().end());
  }
}

bool PendingCommands::isAcceptable(const wire::DeviceCommand& command) const {
  switch (command.command_case()) {
    case wire::DeviceCommand::kJoint:
      switch (command.joint().target_case()) {
        case wire::JointCommand::kPosition:
          return isWithin(command, "position", command.joint().position());
        case wire::JointCommand::kVelocity:
          return isWithin(command, "velocity", command.joint().velocity());
        case wire::JointCommand::kEffort:
          return isWithin(command, "effort", command.joint().effort());
        case wire::JointCommand::TARGET_NOT_SET:
          return false;
      }
      return false;
    case wire::DeviceCommand::kDrive:
      return isWithin(command, "linear", command.drive().linear()) && isWithin(command, "angular", command.drive().angular()) &&
             isInside(command);
    case wire::DeviceCommand::kGripper:
      return isWithin(command, "width", command.gripper().width_m());
    case wire::DeviceCommand::kLevel:
      return isWithin(command, "level", command.level() ? 1 : 0);
    case wire::DeviceCommand::COMMAND_NOT_SET:
      return false;
  }
  return false;
}

bool PendingCommands::isFull() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return commands_.size() >= maxCommands;
}

void PendingCommands::add(wire::DeviceCommand command) {
  const std::lock_guard<std::mutex> lock(mutex_);
  commands_.push_back(std::move(command));
}

PendingCommands::Commands PendingCommands::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(commands_, {});
}

bool PendingCommands::isInside(const wire::DeviceCommand& command) const {
  const auto device = bounds_.find(command.device());
  return device == bounds_.end() || std::all_of(device->second.begin(), device->second.end(), [&](const wire::CommandBound& bound) {
           const auto factor = [&](const char* name) {
             const auto found = bound.factors().find(name);
             return found == bound.factors().end() ? 0.0 : found->second;
           };
           const double sum = factor("linear") * command.drive().linear() + factor("angular") * command.drive().angular();
           return bound.min() <= sum && sum <= bound.max();
         });
}

bool PendingCommands::isWithin(const wire::DeviceCommand& command, const char* name, double value) const {
  const auto device = limits_.find(command.device());
  if (device == limits_.end()) {
    return false;
  }
  const auto number = device->second.find(name);
  return number != device->second.end() && std::isfinite(value) && number->second.first <= value && value <= number->second.second;
}

}  // namespace sitaf::simulation
