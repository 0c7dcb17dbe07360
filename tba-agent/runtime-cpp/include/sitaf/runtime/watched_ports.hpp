#pragma once

#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sitaf/suite/case_result.hpp"

namespace sitaf::runtime {

/// The values of output data ports of the component during a case, which trajectory conditions use. Ports are read whenever simulation
/// time is about to pass, which are all times at which they may have changed.
class WatchedPorts {
 public:
  using Duration = std::chrono::nanoseconds;

  /// Reads the literal of a port, or of a part of it.
  using Read = std::function<std::string()>;

  /// Changes of all ports in a case that are recorded; a record has at most 1 MiB.
  static constexpr std::size_t mostChanges = 20'000;

  /// Watches a port until the end of the case; throws what `read` throws.
  void watch(std::string signal, Read read, Duration now);

  /// Reads all ports. What a port throws is thrown by requireRead, because the component may be running.
  void take(Duration now);

  /// Throws what a port threw.
  void requireRead();

  /// Adds the values to a record, with times since the call.
  void writeTo(suite::CaseResult& result, Duration call) const;

  /// Stops watching.
  void clear();

 private:
  struct Port {
    suite::PortChanges changes;
    Read read;
  };

  void read(Port& port, Duration now);

  std::vector<Port> ports_;
  std::size_t count_ = 0;
  bool reading_ = false;
  std::exception_ptr failure_;
};

}  // namespace sitaf::runtime
