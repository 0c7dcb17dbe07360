#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "sitaf/sim/v1/simulation.pb.h"

namespace sitaf::simulation {

/// Commands that travel with the next step, in the order given, because their devices are known to accept them. Thread-safe.
class PendingCommands {
 public:
  using Commands = std::vector<sim::v1::DeviceCommand>;

  explicit PendingCommands(const sim::v1::WorldDescription& world);

  /// Whether its device is known to accept a command: the numbers are finite and within limits.
  bool isAcceptable(const sim::v1::DeviceCommand& command) const;

  /// Whether the commands must be sent before another one is added.
  bool isFull() const;

  /// Adds a command that is acceptable.
  void add(sim::v1::DeviceCommand command);

  /// Removes and returns all commands.
  Commands take();

 private:
  bool isWithin(const sim::v1::DeviceCommand& command, const char* name, double value) const;
  /// Whether the numbers of a drive are together within the limits of its wheels.
  bool isInside(const sim::v1::DeviceCommand& command) const;

  std::map<std::string, std::map<std::string, std::pair<double, double>>, std::less<>> limits_;
  std::map<std::string, std::vector<sim::v1::CommandBound>, std::less<>> bounds_;
  mutable std::mutex mutex_;
  Commands commands_;
};

}  // namespace sitaf::simulation
