#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "sitaf/sim/v1/simulation.pb.h"

namespace sitaf::simulation {

/// A device of the world, and where its numbers stand in a row of readings.
struct Device {
  std::string name;
  std::string kind;
  std::size_t first = 0;
  std::size_t count = 0;
  /// What of a reading never changes: the limits of a range sensor, the angles and limits of a laser scanner.
  std::vector<double> constants;
};

/// Which number of a row is what: first those of each device, then the observations. The bulk call names its columns in the same way.
class Layout {
 public:
  explicit Layout(const sim::v1::CreateSessionResponse& created);

  const std::vector<Device>& devices() const { return devices_; }
  const Device* device(std::string_view name) const;
  const std::vector<std::string>& observations() const { return observations_; }
  std::size_t firstObservation() const { return firstObservation_; }
  std::size_t width() const { return firstObservation_ + observations_.size(); }
  const std::vector<std::string>& columns() const { return columns_; }

  /// A state's numbers in this order; what a state does not say is NaN.
  void flatten(const sim::v1::WorldState& state, std::vector<double>& row) const;

 private:
  std::vector<Device> devices_;
  std::vector<std::string> observations_;
  std::vector<std::string> columns_;
  std::size_t firstObservation_ = 0;
};

/// What the robot's devices read, and what can be observed, at one step. Components may read it from any thread.
class FrozenWorld {
 public:
  explicit FrozenWorld(const Layout& layout) : layout_(layout), numbers_(layout.width()) {}

  /// Takes over a state of the live session.
  void freeze(const sim::v1::WorldState& state);

  /// Takes over a row of the bulk call, `Layout::width` numbers.
  void freeze(std::chrono::nanoseconds time, const double* row);

  std::chrono::nanoseconds time() const;

  /// Gives the numbers of a row to a reader while none of them changes.
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
