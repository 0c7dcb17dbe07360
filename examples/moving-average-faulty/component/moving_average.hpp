#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace filter {

/// The window is empty or longer than the signal.
struct WindowError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

class MovingAverage {
 public:
  double MeanOfLast(const std::vector<double>& samples, std::int32_t window) const;
};

}  // namespace filter
