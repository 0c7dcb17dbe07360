#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "sitaf/sim/v1/simulation.pb.h"

namespace sitaf::simulation {

/// A device of the world, and the position of its numbers in a row of readings.
struct Device {
  std::string name;
  std::string kind;
  std::size_t first = 0;
  std::size_t count = 0;
  /// The constant numbers of a reading: limits of a range sensor, angles and limits of a laser scanner.
  std::vector<double> constants;
};

/// The columns of a row: the numbers of each device, then the observations. PrepareMany uses the same names for its columns.
class Layout {
 public:
  explicit Layout(const sim::v1::CreateSessionResponse& created);

  const std::vector<Device>& devices() const { return devices_; }
  const Device* device(std::string_view name) const;
  const std::vector<std::string>& observations() const { return observations_; }
  std::size_t firstObservation() const { return firstObservation_; }
  std::size_t width() const { return firstObservation_ + observations_.size(); }
  const std::vector<std::string>& columns() const { return columns_; }

  /// The numbers of a state in this order; NaN for numbers that the state does not contain.
  void flatten(const sim::v1::WorldState& state, std::vector<double>& row) const;

 private:
  std::vector<Device> devices_;
  std::vector<std::string> observations_;
  std::vector<std::string> columns_;
  std::size_t firstObservation_ = 0;
};

/// Readings of all devices and observations at one step. Thread-safe.
class FrozenWorld {
 public:
  explicit FrozenWorld(const Layout& layout) : layout_(layout), numbers_(layout.width()) {}

  /// Stores a state of the session.
  void freeze(const sim::v1::WorldState& state);

  /// Stores a row of PrepareMany, `Layout::width` numbers.
  void freeze(std::chrono::nanoseconds time, const double* row);

  std::chrono::nanoseconds time() const;

  /// Calls a reader with the numbers of the row under the lock, so that they are consistent.
  template <class Reader>
  auto read(std::size_t first, Reader reader) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reader(numbers_.data() + first);
  }

 private:
  const Layout& layout_;
  mutable std::mutex mutex_;
  std::chrono::nanoseconds time_{0};
  std::vector<double> numbers_;
};

}  // namespace sitaf::simulation
