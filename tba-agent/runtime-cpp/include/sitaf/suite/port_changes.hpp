#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace sitaf::suite {

/// The values of an output data port, or of a part of it: the time and the literal of each change.
struct PortChanges {
  std::string signal;
  std::vector<std::pair<std::chrono::nanoseconds, std::string>> changes;
  std::size_t leftOut = 0;
};

}  // namespace sitaf::suite
